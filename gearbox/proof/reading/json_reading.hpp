// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "gearbox/proof/reading/faults.hpp"
#include "io/text/rational.hpp"

namespace torquewright::gearbox::proof {

using Json = nlohmann::json;

/// The value at `key`; nullptr if `json` is no object or has no such key.
const Json* member(const Json& json, std::string_view key);

/// The same as `member`, but JSON's null counts as absent too.
const Json* present(const Json& json, std::string_view key);

/// The elements of an array; an empty array if it is none.
const Json& elements(const Json* json);

std::optional<std::string> text(const Json* json);

/// A JSON integer of 53 bits, so that sums of a few do not overflow.
std::optional<std::int64_t> whole_number(const Json* json);

/// Any finite JSON number, as the decimal that is written: the shortest that reads back.
std::optional<io::Rational> decimal(const Json* json);

/// A fault for every key of `json` that is not among `known`, or if it is no object.
void check_keys(const Json& json, std::initializer_list<std::string_view> known,
                const std::string& place, Faults& faults);

/// `text` as a part of a JSON pointer, short enough for a sentence.
std::string pointer_part(std::string_view text);

}  // namespace torquewright::gearbox::proof
