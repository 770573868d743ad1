#include "tui/practice/score_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "tui/options/own_answer.hpp"
#include "tui/options/standard_streams.hpp"
#include "tui/practice/verdict_output.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/text_table.hpp"
#include "updating/practice/practice_case.hpp"
#include "updating/practice/score_diagnosis.hpp"
#include "updating/session/session.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

struct ScoreWords {
  std::size_t cases = 16;
  std::uint64_t seed = 1;
  std::string shard = "1/1";
  std::vector<std::string> merge;
  std::vector<std::string> kinds;
  bool json = false;
};

// A folder that is gone when the case is done.
class ScratchFolder {
 public:
  explicit ScratchFolder(const std::string& name)
      : path_(fs::temp_directory_path() /
              fmt::format("tapfit-score-{}-{}", ::getpid(), name)) {}
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

ordered_json scored(const std::string& kind,
                    std::uint64_t seed,
                    const Progress& progress) {
  const updating::VirtualBundleSpec spec =
      updating::draw_practice_case(kind, seed);
  const ScratchFolder folder(fmt::format("{}", seed));
  updating::make_virtual_bundle(spec, folder.path(), progress);
  updating::Session session(folder.path());
  const updating::Diagnosis& diagnosis = session.diagnosis(progress);
  const updating::DiagnosisScore v =
      updating::score_diagnosis(spec, diagnosis, session.deck(progress));
  std::vector<std::string> effects;
  for (const updating::VirtualEffect& effect : spec.effects) {
    effects.push_back(updating::virtual_effect_text(effect));
  }
  ordered_json json{{"seed", seed},
                    {"kind", kind},
                    {"effects", effects},
                    {"structure", spec.structure}};
  json.update(verdict_json(v));
  return json;
}

/// Which of how many; nothing where the text is no such thing.
std::optional<std::pair<std::size_t, std::size_t>> shard_of(
    const std::string& text) {
  std::size_t k = 0;
  std::size_t m = 0;
  const char* end = text.data() + text.size();
  const auto [slash, first] = std::from_chars(text.data(), end, k);
  if (first != std::errc() || slash == end || *slash != '/') return {};
  const auto [stop, second] = std::from_chars(slash + 1, end, m);
  if (second != std::errc() || stop != end || k < 1 || k > m) return {};
  return std::pair{k, m};
}

/// What is wrong with a shard as written; empty where nothing is.
std::string shard_fault(const std::string& text) {
  return shard_of(text) ? std::string()
                        : "\"" + text +
                              "\" is no shard: write for example 2/8, the "
                              "second of eight";
}

/// Whether it holds what is counted of a case.
bool is_case(const ordered_json& c) {
  const auto all_are = [&c](std::initializer_list<const char*> names,
                            bool (*is)(const ordered_json&)) {
    return std::ranges::all_of(names, [&](const char* name) {
      return c.contains(name) && is(c.at(name));
    });
  };
  return all_are({"hidden", "found"},
                 [](const ordered_json& v) { return v.is_string(); }) &&
         all_are({"right_kind", "right_place"},
                 [](const ordered_json& v) { return v.is_boolean(); }) &&
         all_are(
             {"intervals", "intervals_hold"},
             [](const ordered_json& v) { return v.is_number_unsigned(); }) &&
         all_are({"size_error", "error", "floor"},
                 [](const ordered_json& v) { return v.is_number(); });
}

ordered_json read_parts(const std::vector<std::string>& files) {
  ordered_json all = ordered_json::array();
  for (const std::string& file : files) {
    const ordered_json part =
        ordered_json::parse(acquisition::read_input(file), nullptr, false);
    const auto cases = part.find("cases");
    if (cases == part.end() || !cases->is_array() ||
        !std::ranges::all_of(*cases, is_case)) {
      throw InputError("cannot be read as a score",
                       file,
                       "give files that tapfit score --json printed");
    }
    for (const ordered_json& c : *cases) all.push_back(c);
  }
  return all;
}

std::string percent_of(std::size_t part, std::size_t whole) {
  if (whole == 0) return "-";
  const double percent =
      100.0 * static_cast<double>(part) / static_cast<double>(whole);
  return fmt::format("{}/{} ({:.0f} %)", part, whole, percent);
}

// Rows: what was hidden; columns: how it came out.
std::string matrix_text(const ordered_json& cases) {
  std::map<std::string, std::map<std::string, int>> counts;
  for (const ordered_json& c : cases) ++counts[c["hidden"]][c["found"]];
  TextTable table({"<hidden", "<found", "cases"});
  for (const auto& [hidden, found] : counts) {
    for (const auto& [name, count] : found) {
      table.add({hidden, name, fmt::format("{}", count)});
    }
  }
  return table.text();
}

std::string summary_text(const ordered_json& cases) {
  std::size_t kind = 0;
  std::size_t place = 0;
  std::size_t intervals = 0;
  std::size_t hold = 0;
  std::size_t near_floor = 0;
  std::size_t explained = 0;
  std::vector<double> sizes;
  for (const ordered_json& c : cases) {
    const bool right = c["right_kind"];
    kind += right ? 1 : 0;
    if (!right || c["found"] == "unexplained") continue;
    ++explained;
    place += c["right_place"].get<bool>() ? 1 : 0;
    intervals += c["intervals"].get<std::size_t>();
    hold += c["intervals_hold"].get<std::size_t>();
    if (c["intervals"] > 0) sizes.push_back(c["size_error"]);
    const double ratio = c["error"].get<double>() / c["floor"].get<double>();
    near_floor += ratio <= 1.3 ? 1 : 0;
  }
  std::sort(sizes.begin(), sizes.end());
  const auto within = std::count_if(
      sizes.begin(), sizes.end(), [](double e) { return e <= 0.05; });
  return fmt::format(
      "right effect      {}\n"
      "right place       {} of those\n"
      "size within 5 %   {}, median error {:.1f} %\n"
      "error at floor    {} (within 1.3 times)\n"
      "95 % intervals    {} hold\n",
      percent_of(kind, cases.size()),
      percent_of(place, explained),
      percent_of(static_cast<std::size_t>(within), sizes.size()),
      sizes.empty() ? 0.0 : 100.0 * sizes[sizes.size() / 2],
      percent_of(near_floor, explained),
      percent_of(hold, intervals));
}

ordered_json run_cases(const ScoreWords& words, const Progress& progress) {
  const auto [k, m] = shard_of(words.shard).value();
  const std::vector<std::string>& kinds =
      words.kinds.empty() ? updating::practice_kinds() : words.kinds;
  ordered_json cases = ordered_json::array();
  for (std::size_t at = k - 1; at < words.cases; at += m) {
    const ordered_json c =
        scored(kinds[at % kinds.size()], 1000 * words.seed + at, progress);
    say(fmt::format("{:>4} {:<8} {:<26} {:<30} {} {:.1f} %\n",
                    at,
                    c["structure"].get<std::string>(),
                    c["hidden"].get<std::string>(),
                    c["found"].get<std::string>(),
                    c["right_kind"].get<bool>()
                        ? (c["right_place"].get<bool>() ? "right" : "elsewhere")
                        : "WRONG",
                    100.0 * c["size_error"].get<double>()));
    cases.push_back(c);
  }
  return cases;
}

}  // namespace

int score_command(int argc, const char* const* argv, const Progress& progress) {
  CLI::App app("Diagnoses practice cases and counts how often it was right",
               "tapfit score");
  ScoreWords words;
  app.add_option("--cases", words.cases, "how many cases")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--seed", words.seed, "same seed, same cases");
  app.add_option("--shard", words.shard, "K/M: only part K of M")
      ->check(CLI::Validator(shard_fault, "K/M"));
  app.add_option("--kind", words.kinds, "hide only this (may be repeated)")
      ->check(CLI::IsMember(updating::practice_kinds()))
      ->take_all();
  app.add_option("--merge", words.merge, "files printed with --json");
  app.add_flag("--json", words.json, "print one JSON object");
  if (const auto status = answered(app, argc, argv)) return *status;
  const ordered_json cases = words.merge.empty() ? run_cases(words, progress)
                                                 : read_parts(words.merge);
  if (words.json) {
    print(json_text(ordered_json{{"cases", cases}}));
  } else {
    print(matrix_text(cases) + summary_text(cases));
  }
  return 0;
}

}  // namespace tapfit::tui
