// SPDX-License-Identifier: Apache-2.0
#include "tests/real_data/robots/stripped_mjcf.hpp"

#include <tinyxml2.h>

#include <set>
#include <stdexcept>
#include <string_view>

namespace torquewright::test {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

const std::set<std::string_view> kDropped{
    "asset",     "visual",   "statistic", "contact",  "sensor",   "keyframe", "custom",
    "size",      "actuator", "tendon",    "equality", "camera",   "light",    "site",
    "extension", "general",  "motor",     "position", "velocity", "adhesion", "mesh",
    "material",  "pair",     "fixed",     "spatial",  "cylinder", "muscle"};
const std::set<std::string_view> kDroppedAttributes{
    "actuatorfrcrange", "actuatorfrclimited", "gravcomp",     "material", "assetdir",
    "meshdir",          "texturedir",         "discardvisual"};

void load(const fs::path& file, XMLDocument& document) {
  if (document.LoadFile(file.c_str()) == tinyxml2::XML_SUCCESS) return;
  throw std::runtime_error("cannot be read: " + file.string());
}

/// The content of included files, before the element that names them.
void include(XMLElement& element, const fs::path& main) {
  for (XMLElement* next = element.FirstChildElement(); next != nullptr;) {
    XMLElement* const after = next->NextSiblingElement();
    if (std::string_view(next->Name()) == "include") {
      XMLDocument other;
      load(main.parent_path() / next->Attribute("file"), other);
      include(*other.RootElement(), main);
      tinyxml2::XMLNode* place = next;
      for (auto* held = other.RootElement()->FirstChildElement(); held != nullptr;
           held = held->NextSiblingElement()) {
        place = element.InsertAfterChild(place, held->DeepClone(element.GetDocument()));
      }
      element.DeleteChild(next);
    } else {
      include(*next, main);
    }
    next = after;
  }
}

bool is_mesh(const XMLElement& geom) {
  const std::string_view type = geom.Attribute("type") == nullptr ? "" : geom.Attribute("type");
  return geom.Attribute("mesh") != nullptr || type == "mesh" || type == "hfield";
}

/// Of options and flags only gravity moves what we compare.
void keep_gravity(XMLElement& element) {
  const char* found = element.Attribute("gravity");
  const std::string gravity = found == nullptr ? "" : found;
  while (element.FirstAttribute() != nullptr) {
    element.DeleteAttribute(std::string(element.FirstAttribute()->Name()).c_str());
  }
  if (!gravity.empty()) element.SetAttribute("gravity", gravity.c_str());
}

void strip(XMLElement& element, bool is_default) {
  const std::string_view own = element.Name();
  if (own == "option" || own == "flag") keep_gravity(element);
  for (const std::string_view name : kDroppedAttributes) {
    element.DeleteAttribute(std::string(name).c_str());
  }
  for (XMLElement* next = element.FirstChildElement(); next != nullptr;) {
    XMLElement* const after = next->NextSiblingElement();
    const std::string_view name = next->Name();
    const bool inside_default = is_default || name == "default";
    if (kDropped.contains(name)) {
      element.DeleteChild(next);
    } else if (name == "geom" && !is_default && is_mesh(*next)) {
      element.DeleteChild(next);
    } else {
      if (name == "geom" && is_mesh(*next)) next->DeleteAttribute("type");
      strip(*next, inside_default);
      // Frames hold nothing but shapes in files that state masses.
      if (name == "frame" && next->NoChildren()) element.DeleteChild(next);
    }
    next = after;
  }
}

/// Shapes of a class that is for meshes have lost their mesh, and would be points.
void drop_points(XMLElement& element) {
  for (XMLElement* next = element.FirstChildElement(); next != nullptr;) {
    XMLElement* const after = next->NextSiblingElement();
    const std::string_view name = next->Name();
    const bool has_inertia = element.FirstChildElement("inertial") != nullptr;
    if ((name == "geom" && has_inertia) || name == "frame") {
      element.DeleteChild(next);
    } else if (name != "default") {
      drop_points(*next);
    }
    next = after;
  }
}

/// Each shape in a body of its own, welded: of one shape MuJoCo knows the principal axes exactly,
/// of several to some 1e-8.
void wrap_shapes(XMLElement& element) {
  for (XMLElement* next = element.FirstChildElement(); next != nullptr;) {
    XMLElement* const after = next->NextSiblingElement();
    const std::string_view name = next->Name();
    if (name == "geom" && std::string_view(element.Name()) == "body") {
      XMLElement* wrapper = element.GetDocument()->NewElement("body");
      element.InsertAfterChild(next, wrapper);
      wrapper->InsertEndChild(next);
    } else if (name != "default") {
      wrap_shapes(*next);
    }
    next = after;
  }
}

bool counts_shapes(const XMLElement& root) {
  for (auto* next = root.FirstChildElement("compiler"); next != nullptr;
       next = next->NextSiblingElement("compiler")) {
    const char* rule = next->Attribute("inertiafromgeom");
    if (rule != nullptr && std::string_view(rule) == "true") return true;
  }
  return false;
}

}  // namespace

std::string stripped_mjcf(const fs::path& file) {
  XMLDocument document;
  load(file, document);
  XMLElement& root = *document.RootElement();
  include(root, file);
  strip(root, false);
  if (!counts_shapes(root)) drop_points(root);
  wrap_shapes(root);
  // What a newer MuJoCo takes for granted; what the file says overrules it.
  XMLElement* compiler = document.NewElement("compiler");
  compiler->SetAttribute("autolimits", "true");
  root.InsertFirstChild(compiler);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

}  // namespace torquewright::test
