#include "acquisition/bundle/read_test_json.hpp"

#include "acquisition/bundle/test_schema.hpp"
#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/nearest_word.hpp"
#include "acquisition/foundation/parse_json.hpp"
#include "acquisition/foundation/utf8.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

namespace tapfit::acquisition {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

// Where something of nearly that name lies there.
std::string meant_beside(const fs::path& file) {
  constexpr std::size_t most_looked_at = 10000;
  const fs::path folder = file.parent_path();
  std::vector<std::string> names;
  std::error_code fault;
  fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, fault);
  for (; !fault && at != fs::directory_iterator() &&
         names.size() < most_looked_at;
       at.increment(fault)) {
    names.push_back(at->path().filename().string());
  }
  return did_you_mean(file.filename().string(), names);
}

std::string read_text(const fs::path& file) {
  std::ifstream stream = open_input(file, most_text_bytes);
  if (!stream) {
    throw InputError("cannot be opened",
                     file.string(),
                     meant_beside(file) +
                         "give the folder of a test bundle, with a test.json "
                         "in it, or a universal file");
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

// A file that was named or linked instead of a bundle's and begins like no JSON
// object: nothing of it is quoted.
void refuse_foreign(const fs::path& file) {
  std::ifstream in = open_input(file);
  char first = ' ';
  // A byte order mark may stand in front; an empty file is told of later.
  std::string mark(3, ' ');
  if (!in.read(mark.data(), 3) || mark != "\xef\xbb\xbf") {
    in.clear();
    in.seekg(0);
  }
  if (!(in >> first) || first == '{') return;
  // Of a list in a .json the schema says what is wrong.
  if (first == '[' && file.extension() == ".json") return;
  throw InputError(
      "not a test bundle: expected a folder with test.json, a test.json, or a "
      "universal file (.uff, a line of \"    -1\" first)",
      file.string(),
      "give the bundle's folder; `tapfit import` makes a bundle of CSV, MATLAB "
      "and SEP-005 files, and recordings are named in a test.json");
}

// Line ends and tabs are blanks; of other controls the first is said.
void make_one_line(std::string& text,
                   const std::string& place,
                   const std::string& source) {
  std::ranges::replace_if(
      text, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  if (printable(text) == text) return;
  throw InputError(
      fmt::format("\"{}\" holds a control character (shown as ?)", text),
      fmt::format("{}: {}", source, place),
      "write it without: such characters steer terminals, or turn the "
      "direction of writing");
}

// All texts of a test.json: they come to terminals, tables and reports.
// NOLINTNEXTLINE(misc-no-recursion): no deeper than any field that is read
void make_one_lines(json& value,
                    const std::string& place,
                    const std::string& source,
                    int depth = 0) {
  constexpr int deepest = 16;
  if (depth > deepest) return;
  if (value.is_string()) {
    make_one_line(value.get_ref<std::string&>(), place, source);
  } else if (value.is_array()) {
    for (std::size_t k = 0; k < value.size(); ++k) {
      make_one_lines(
          value[k], fmt::format("{}[{}]", place, k), source, depth + 1);
    }
  } else if (value.is_object()) {
    for (auto& [key, child] : value.items()) {
      const std::string at = place.empty() ? key : place + "." + key;
      std::string name = key;
      make_one_line(name, at, source);
      make_one_lines(child, at, source, depth + 1);
    }
  }
}

void add_model(const json& model, const fs::path& folder, TestBundle& bundle) {
  const auto path = [&](const json& said) {
    return folder / said.get<std::string>();
  };
  if (model.is_string()) {
    bundle.deck = path(model);
  } else {
    bundle.matrices = MatrixModel{path(model.at("stiffness")),
                                  path(model.at("mass")),
                                  path(model.at("dofs"))};
  }
}

}  // namespace

fs::path test_json_of(const fs::path& bundle) {
  std::error_code ignored;
  return fs::is_directory(bundle, ignored) ? bundle / "test.json" : bundle;
}

json read_test_json(const fs::path& file) {
  refuse_foreign(file);
  const std::string name = file.filename().string();
  json document = parse_json(read_text(file), name);
  make_one_lines(document, "", name);
  check_against_schema(document, name);
  return document;
}

TestBundle read_bundle_paths(const fs::path& bundle) {
  TestBundle paths;
  paths.file = test_json_of(bundle);
  paths.folder = paths.file.parent_path();
  if (is_uff(bundle)) return paths;
  const json document = read_test_json(paths.file);
  const auto path = [&](const json& said) {
    return paths.folder / said.get<std::string>();
  };
  if (document.contains("model")) {
    add_model(document["model"], paths.folder, paths);
  }
  if (document.contains("frfs")) paths.frfs = path(document["frfs"]);
  if (document.contains("modes")) {
    const json& modes = document["modes"];
    paths.modes.emplace().file =
        path(modes.is_string() ? modes : modes.at("file"));
  }
  if (document.contains("geometry") && document["geometry"].contains("file")) {
    paths.geometry.emplace().file = path(document["geometry"]["file"]);
  }
  for (const json& run : document.value("runs", json::array())) {
    paths.runs.emplace_back().file = path(run.at("file"));
  }
  return paths;
}

}  // namespace tapfit::acquisition
