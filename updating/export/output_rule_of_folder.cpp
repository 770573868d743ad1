#include "updating/export/output_rule_of_folder.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "updating/structure/cards/bulk_lines.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Before a recording is read as text: an object begins with a brace, behind a
// byte order mark maybe.
bool may_be_object(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  char c = ' ';
  while (in.get(c) && (std::isspace(static_cast<unsigned char>(c)) != 0 ||
                       c == '\xef' || c == '\xbb' || c == '\xbf')) {
  }
  return in && c == '{';
}

// What is no JSON is an object without entries. Numbers inside are left out: in
// a record of samples they are many.
json object_in(const fs::path& file) {
  const auto may_be_name =
      [](int depth, json::parse_event_t event, const json& value) {
        return depth <= 1 || event != json::parse_event_t::value ||
               value.is_string();
      };
  try {
    json document =
        json::parse(acquisition::read_input(file), may_be_name, false);
    return document.is_object() ? document : json::object();
  } catch (const InputError&) {
    return json::object();
  }
}

// Whatever of it is the name of a file: a test that cannot be read is not asked
// which fields it has.
void add_named(const json& value,
               const fs::path& folder,
               std::vector<fs::path>& files) {
  if (value.is_structured()) {
    for (const json& entry : value) add_named(entry, folder, files);
  }
  if (!value.is_string() || value.get_ref<const std::string&>().empty()) return;
  const fs::path file = folder / value.get_ref<const std::string&>();
  std::error_code none;
  if (fs::is_regular_file(file, none)) files.push_back(file);
}

std::vector<fs::path> inputs_of(const fs::path& test) {
  const json document = object_in(test);
  std::vector<fs::path> files{test};
  add_named(document, test.parent_path(), files);
  const auto model = document.find("model");
  if (model == document.end() || !model->is_string()) return files;
  const fs::path deck = test.parent_path() / model->get<std::string>();
  for (fs::path& file : structure::deck_files(deck)) {
    files.push_back(std::move(file));
  }
  return files;
}

bool is_test(const fs::path& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return false;
  if (file.filename() == "test.json") return true;
  return may_be_object(file) && object_in(file).contains("tapfit");
}

}  // namespace

acquisition::OutputRule output_rule_of_folder(
    const fs::path& folder, bool force, const std::vector<fs::path>& made) {
  const acquisition::OutputRule own{made, true};
  acquisition::OutputRule rule{{}, force};
  std::error_code none;
  for (fs::directory_iterator at(folder, none), end; !none && at != end;
       at.increment(none)) {
    if (!is_test(at->path())) continue;
    const bool ours = own.is_input(at->path());
    for (fs::path& file : inputs_of(at->path())) {
      if (!ours || !own.is_input(file)) rule.inputs.push_back(std::move(file));
    }
  }
  return rule;
}

}  // namespace tapfit::updating
