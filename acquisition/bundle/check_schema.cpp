// Schema validation is valijson's; what is added here is the place of an error
// in the user's own notation and a remedy taken from the schema's descriptions.
#include "acquisition/bundle/test_schema.hpp"
#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <algorithm>

namespace tapfit::acquisition {
namespace {

using nlohmann::json;

// Follows "$ref": "#/definitions/NAME".
const json& resolve(const json& root, const json& node) {
  if (!node.contains("$ref")) return node;
  const std::string reference = node["$ref"].get<std::string>();
  return root.at(json::json_pointer(reference.substr(1)));
}

// The sub-schema for one step: a property's name, or an index into a list.
const json* step_into(const json& root,
                      const json& node,
                      const std::string& step) {
  if (node.contains("properties") && node["properties"].contains(step)) {
    return &resolve(root, node["properties"][step]);
  }
  if (node.contains("items")) return &resolve(root, node["items"]);
  return nullptr;
}

bool is_index(const std::string& step) {
  return !step.empty() && std::all_of(step.begin(), step.end(), [](char c) {
    return c >= '0' && c <= '9';
  });
}

// valijson gives the context as "<root>", "[runs]", "[2]", "[file]".
std::vector<std::string> steps_of(const std::vector<std::string>& context) {
  std::vector<std::string> steps;
  for (const std::string& part : context) {
    if (part.size() < 2 || part.front() != '[') continue;
    steps.push_back(part.substr(1, part.size() - 2));
  }
  return steps;
}

std::string place_of(const std::vector<std::string>& steps) {
  std::string place;
  for (const std::string& step : steps) {
    if (is_index(step)) {
      place += fmt::format("[{}]", step);
    } else {
      place += fmt::format("{}{}", place.empty() ? "" : ".", step);
    }
  }
  return place;
}

std::string description_of(const json& root,
                           const std::vector<std::string>& steps) {
  const json* node = &root;
  for (const std::string& step : steps) {
    const json* next = step_into(root, *node, step);
    if (next == nullptr) break;
    node = next;
  }
  return node->value("description", std::string("see docs/test-bundle.md"));
}

// Errors of a parent only repeat that a child failed; the child says why.
bool repeats_child(const std::string& description) {
  return description.starts_with("Failed to validate against schema") ||
         description.starts_with("Failed to validate item") ||
         description.starts_with("Failed to validate against child schema");
}

std::string sentence(std::string text) {
  while (!text.empty() && (text.back() == '.' || text.back() == ' ')) {
    text.pop_back();
  }
  if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') {
    text[0] = static_cast<char>(text[0] - 'A' + 'a');
  }
  return text;
}

void collect_unknown(const json& root,
                     const json& node,
                     const json& value,
                     const std::string& place,
                     std::vector<std::string>& found) {
  if (value.is_object() && node.contains("properties")) {
    for (const auto& [key, child] : value.items()) {
      const std::string here =
          place.empty() ? key : fmt::format("{}.{}", place, key);
      if (!node["properties"].contains(key)) {
        found.push_back(here);
      } else {
        const json& sub = resolve(root, node["properties"][key]);
        collect_unknown(root, sub, child, here, found);
      }
    }
  } else if (value.is_array() && node.contains("items")) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string here = fmt::format("{}[{}]", place, i);
      collect_unknown(
          root, resolve(root, node["items"]), value[i], here, found);
    }
  }
}

}  // namespace

void check_against_schema(const json& document, const std::string& source) {
  const json root = json::parse(test_schema());
  valijson::Schema schema;
  valijson::SchemaParser parser;
  const valijson::adapters::NlohmannJsonAdapter schema_adapter(root);
  parser.populateSchema(schema_adapter, schema);

  valijson::Validator validator;
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter adapter(document);
  if (validator.validate(schema, adapter, &results)) return;

  valijson::ValidationResults::Error error;
  valijson::ValidationResults::Error first;
  while (results.popError(error)) {
    if (first.description.empty()) first = error;
    if (!repeats_child(error.description)) {
      first = error;
      break;
    }
  }
  const std::vector<std::string> steps = steps_of(first.context);
  const std::string place = place_of(steps);
  throw InputError(
      sentence(first.description),
      place.empty() ? source : fmt::format("{}: {}", source, place),
      fmt::format("expected: {}", description_of(root, steps)));
}

std::vector<std::string> unknown_fields(const json& document) {
  const json root = json::parse(test_schema());
  std::vector<std::string> found;
  collect_unknown(root, root, document, "", found);
  return found;
}

}  // namespace tapfit::acquisition
