// SPDX-License-Identifier: Apache-2.0
#include "io/table_forms/matlab_file.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "io/faults/refusal.hpp"
#include "io/table_forms/array_table.hpp"
#include "io/table_forms/matio_library.hpp"

namespace torquewright::io {
namespace {

constexpr int kDeepestStruct = 8;

struct NamedVariable {
  std::string name;
  const matvar_t* variable = nullptr;
};

std::string is_no_column_since(const matvar_t& variable) {
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
    case MAT_C_SINGLE:
    case MAT_C_INT8:
    case MAT_C_UINT8:
    case MAT_C_INT16:
    case MAT_C_UINT16:
    case MAT_C_INT32:
    case MAT_C_UINT32:
    case MAT_C_INT64:
    case MAT_C_UINT64:
      break;
    case MAT_C_CHAR:
      return "text";
    case MAT_C_CELL:
      return "cells";
    case MAT_C_STRUCT:
      return "an array of structs";
    case MAT_C_SPARSE:
      return "a sparse matrix";
    default:
      return "an object, as tables and timetables are";
  }
  if (variable.isComplex != 0) return "complex numbers";
  if (variable.rank != 2) return "of more than two dimensions";
  return variable.data == nullptr ? "empty" : "";
}

NamedArray variable_described(const NamedVariable& array) {
  const matvar_t& variable = *array.variable;
  NamedArray named{array.name, 0, 0, is_no_column_since(variable)};
  if (!named.is_no_column.empty()) return named;
  named.length = variable.dims[0];
  named.width = variable.dims[1];
  return named;
}

template <class Number>
void append_value(const void* data, std::size_t index, std::string& text) {
  Number number;
  std::memcpy(&number, static_cast<const char*>(data) + index * sizeof number, sizeof number);
  fmt::format_to(std::back_inserter(text), "{}", +number);
}

void print_number(const matvar_t& variable, std::size_t index, std::string& text) {
  switch (variable.class_type) {
    case MAT_C_SINGLE:
      return append_value<float>(variable.data, index, text);
    case MAT_C_INT8:
      return append_value<std::int8_t>(variable.data, index, text);
    case MAT_C_UINT8:
      return append_value<std::uint8_t>(variable.data, index, text);
    case MAT_C_INT16:
      return append_value<std::int16_t>(variable.data, index, text);
    case MAT_C_UINT16:
      return append_value<std::uint16_t>(variable.data, index, text);
    case MAT_C_INT32:
      return append_value<std::int32_t>(variable.data, index, text);
    case MAT_C_UINT32:
      return append_value<std::uint32_t>(variable.data, index, text);
    case MAT_C_INT64:
      return append_value<std::int64_t>(variable.data, index, text);
    case MAT_C_UINT64:
      return append_value<std::uint64_t>(variable.data, index, text);
    default:
      return append_value<double>(variable.data, index, text);
  }
}

/// Of a file of version 5 each variable says how long it is, and matio makes zeros of what is not
/// there. (HDF5 refuses a file that was cut.)
void require_whole(const std::string& file) {
  constexpr std::uintmax_t kHeaderBytes = 128, kTagBytes = 8;
  std::ifstream in(file, std::ios::binary);
  char head[kHeaderBytes] = "";
  in.read(head, sizeof head);
  if (!std::string_view(head, sizeof head).starts_with("MATLAB 5")) return;
  const bool is_greatest_first = head[kHeaderBytes - 2] == 'M';
  const std::uintmax_t size = std::filesystem::file_size(file);
  for (std::uintmax_t at = kHeaderBytes; at != size;) {
    unsigned char tag[kTagBytes] = "";
    in.seekg(static_cast<std::streamoff>(at));
    in.read(reinterpret_cast<char*>(tag), sizeof tag);
    std::uintmax_t length = 0;
    for (std::size_t i = 4; i < kTagBytes; ++i) {
      length = 256 * length + tag[is_greatest_first ? i : kTagBytes + 3 - i];
    }
    if (!in || length > size - at - kTagBytes) {
      refuse(file, fmt::format("ends within the variable that begins at byte {}", at));
    }
    at += kTagBytes + length;
  }
}

/// All that a file holds.
class Variables {
 public:
  explicit Variables(const std::string& file) : matio_(matio_library(file)) {
    require_whole(file);
    mat_t* const open = matio_.open(file.c_str(), MAT_ACC_RDONLY);
    if (open == nullptr) refuse(file, "begins as a MATLAB file, and matio cannot open it");
    while (matvar_t* const variable = matio_.read_next(open)) {
      variables_.push_back(variable);
      add(variable->name == nullptr ? "" : variable->name, *variable, 0);
    }
    matio_.close(open);
  }
  Variables(const Variables&) = delete;
  Variables& operator=(const Variables&) = delete;
  ~Variables() {
    for (matvar_t* const each : variables_) matio_.free(each);
  }

  const std::vector<NamedVariable>& arrays() const { return arrays_; }

 private:
  /// A variable, or the fields of one struct.
  void add(const std::string& name, matvar_t& variable, int depth) {
    const bool is_one_struct = variable.class_type == MAT_C_STRUCT && variable.rank == 2 &&
                               variable.dims[0] == 1 && variable.dims[1] == 1;
    if (!is_one_struct || depth == kDeepestStruct) {
      arrays_.push_back({name, &variable});
      return;
    }
    char* const* const names = matio_.field_names(&variable);
    for (unsigned i = 0; i < matio_.count_fields(&variable); ++i) {
      matvar_t* const field = matio_.field(&variable, i, 0);
      if (field != nullptr) add(fmt::format("{}.{}", name, names[i]), *field, depth + 1);
    }
  }

  const MatioLibrary& matio_;
  std::vector<matvar_t*> variables_;
  std::vector<NamedVariable> arrays_;
};

class MatlabFile : public ArrayText {
 public:
  MatlabFile(ArrayTable table, std::unique_ptr<ByteSource> bytes,
             std::unique_ptr<Variables> variables)
      : ArrayText(std::move(table), std::move(bytes)),
        variables_(std::move(variables)),
        rows_given_(this->table().parts.size()) {}

 private:
  /// Arrays lie column by column.
  void append_number(std::size_t column, std::string& text) override {
    const ArrayTable::Part& part = table().parts[column];
    const matvar_t& variable = *variables_->arrays()[part.array].variable;
    const std::size_t row = rows_given_[column]++;
    const std::size_t index = part.lies_across ? row * variable.dims[0] + part.column
                                               : part.column * variable.dims[0] + row;
    print_number(variable, index, text);
  }

  std::unique_ptr<Variables> variables_;
  std::vector<std::size_t> rows_given_;
};

}  // namespace

bool begins_as_matlab_file(std::string_view first_bytes) {
  return first_bytes.starts_with("MATLAB 5.0 MAT-file") ||
         first_bytes.starts_with("MATLAB 7.3 MAT-file");
}

std::unique_ptr<ByteSource> matlab_file(std::unique_ptr<ByteSource> bytes,
                                        const std::string& file) {
  auto variables = std::make_unique<Variables>(file);
  std::vector<NamedArray> named;
  for (const NamedVariable& each : variables->arrays()) named.push_back(variable_described(each));
  return std::make_unique<MatlabFile>(table_of_arrays(file, "a MATLAB file", named, 1),
                                      std::move(bytes), std::move(variables));
}

}  // namespace torquewright::io
