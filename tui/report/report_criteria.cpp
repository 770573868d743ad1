#include "tui/report/report_criteria.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"
#include "updating/comparison/criteria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

namespace tapfit::tui {
namespace {

using acquisition::Limits;
using updating::Comparison;
using updating::Criteria;
using updating::keeps_one;
using updating::ModePair;

/// One criterion and how its value and its limit are written.
struct Criterion : updating::Criterion {
  int decimals;
  const char* unit;
  const char* words;  ///< at its worst
  const char* brief;  ///< in a sentence, before its limit
  const char* column;
};
constexpr std::array<Criterion, 4> criteria{
    {{updating::criteria[0],
      2,
      " %",
      "largest frequency error of a pair",
      "frequency within",
      "error"},
     {updating::criteria[1],
      3,
      "",
      "smallest MAC of a pair",
      "MAC at least",
      "MAC"},
     {updating::criteria[2],
      3,
      "",
      "smallest cross-orthogonality of a pair",
      "cross-orthogonality on the diagonal at least",
      "cross-orth."},
     {updating::criteria[3],
      3,
      "",
      "largest cross-orthogonality off the diagonal",
      "cross-orthogonality off the diagonal at most",
      "off diagonal"}}};

const char* judged_words(std::optional<bool> kept) {
  return !kept ? "not tested" : *kept ? "✓ pass" : "✗ fail";
}

std::string value_text(const Criterion& one,
                       const std::optional<double>& value) {
  return value ? fixed(*value, one.decimals) + one.unit : "–";
}

/// One comparison, judged.
struct Judged {
  const Comparison* comparison = nullptr;
  const char* when = "model";  ///< or "before", "after"
  std::vector<Criteria> modes;
  Criteria worst;
  updating::Tally tally;
};

Judged judged(const Comparison& comparison,
              const char* when,
              const ReportData& data) {
  const auto modes = updating::criteria_of(comparison, data.modes.modes.size());
  const updating::Tally counted = updating::tally(modes, data.notes.limits);
  return {&comparison, when, modes, updating::worst_of(modes), counted};
}

/// As delivered, and as it is now where that is another model.
std::vector<Judged> all_judged(const ReportData& data) {
  const ModelResults& model = *data.model;
  if (model.ladder.size() < 2) return {judged(model.before, "model", data)};
  return {judged(model.before, "before", data),
          judged(model.after, "after", data)};
}

std::string limit_words(const Criterion& one, const Limits& limits) {
  const std::optional<double>& limit = limits.*one.limit;
  if (!limit) return "none set";
  return fmt::format(
      "{} {}{}", one.at_least ? "≥" : "≤", number(*limit), one.unit);
}

void add_worst_rows(const std::vector<Judged>& models,
                    const Limits& limits,
                    DataTable& table) {
  for (const Criterion& one : criteria) {
    const auto known = [&one](const Judged& model) {
      return (model.worst.*one.found).has_value();
    };
    if (!(limits.*one.limit) && !std::ranges::any_of(models, known)) continue;
    std::vector<std::string> row{one.words};
    if (updating::any_limit(limits)) row.push_back(limit_words(one, limits));
    for (const Judged& model : models) {
      row.push_back(value_text(one, model.worst.*one.found));
      if (!updating::any_limit(limits)) continue;
      row.emplace_back(limits.*one.limit
                           ? judged_words(keeps_one(one, model.worst, limits))
                           : "–");
    }
    table.rows.push_back(std::move(row));
  }
}

void add_count_rows(const std::vector<Judged>& models,
                    const Limits& limits,
                    DataTable& table) {
  const bool limited = updating::any_limit(limits);
  std::vector<std::string> pairs{"measured modes with a pair"};
  if (limited) pairs.emplace_back("all");
  std::vector<std::string> kept{"measured modes that keep all limits", "all"};
  for (const Judged& model : models) {
    const auto paired =
        std::ranges::count(model.modes, true, &Criteria::paired);
    pairs.push_back(fmt::format("{} of {}", paired, model.modes.size()));
    if (!limited) continue;
    pairs.emplace_back(judged_words(model.worst.paired));
    kept.push_back(
        fmt::format("{} of {}", model.tally.kept, model.tally.modes));
    kept.emplace_back(judged_words(model.tally.verdict()));
  }
  table.rows.push_back(std::move(pairs));
  if (limited) table.rows.push_back(std::move(kept));
}

DataTable worst_table(const ReportData& data,
                      const std::vector<Judged>& models) {
  DataTable table{"", {"<criterion"}, {}};
  const bool limited = updating::any_limit(data.notes.limits);
  if (limited) table.heading.emplace_back("<limit");
  for (const Judged& model : models) {
    table.heading.emplace_back(model.when);
    if (limited) table.heading.emplace_back("<");
  }
  add_worst_rows(models, data.notes.limits, table);
  add_count_rows(models, data.notes.limits, table);
  return table;
}

/// Frequency and MAC are always told, the rest where a limit is set.
bool is_told(const Criterion& one, const Limits& limits) {
  return one.limit == &Limits::frequency_percent || one.limit == &Limits::mac ||
         (limits.*one.limit).has_value();
}

std::string mode_cell(const Criterion& one,
                      const Criteria& mode,
                      const ModePair* pair,
                      const Limits& limits) {
  if (pair == nullptr) return "–";
  std::string text = one.limit == &Limits::frequency_percent
                         ? signed_percent_words(pair->error_percent)
                         : value_text(one, mode.*one.found);
  if (keeps_one(one, mode, limits) == false) text += " ✗";
  return text;
}

void add_mode_cells(const Judged& model,
                    std::size_t mode,
                    const Limits& limits,
                    std::vector<std::string>& row) {
  const std::vector<ModePair>& pairs = model.comparison->pairs;
  const Criteria& found = model.modes[mode];
  const auto pair =
      std::ranges::find(pairs, static_cast<int>(mode), &ModePair::measured);
  const ModePair* known = pair == pairs.end() ? nullptr : &*pair;
  row.push_back(known == nullptr ? "–" : fixed(known->model_hz, 3));
  for (const Criterion& one : criteria) {
    if (is_told(one, limits)) {
      row.push_back(mode_cell(one, found, known, limits));
    }
  }
  if (updating::any_limit(limits))
    row.emplace_back(judged_words(updating::keeps(found, limits)));
}

DataTable mode_table_of(const ReportData& data,
                        std::span<const Judged> models,
                        const std::string& caption) {
  const Limits& limits = data.notes.limits;
  DataTable table{caption, {"mode", "measured Hz"}, {}};
  for (const Judged& model : models) {
    table.heading.push_back(fmt::format("{} Hz", model.when));
    for (const Criterion& one : criteria) {
      if (is_told(one, limits)) table.heading.emplace_back(one.column);
    }
    if (updating::any_limit(limits)) table.heading.emplace_back("<");
  }
  for (std::size_t k = 0; k < data.modes.modes.size(); ++k) {
    std::vector<std::string> row{fmt::format("{}", k + 1),
                                 fixed(data.modes.modes[k].frequency_hz, 3)};
    for (const Judged& model : models) add_mode_cells(model, k, limits, row);
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Before and after in one table; with limits in one for each, as both would
/// be wider than a sheet of paper.
void add_mode_tables(const ReportData& data,
                     std::span<const Judged> models,
                     std::vector<Part>& parts) {
  const std::string caption = "Modes of measurement and model";
  if (models.size() == 1 || !updating::any_limit(data.notes.limits)) {
    parts.emplace_back(mode_table_of(data, models, caption));
    return;
  }
  for (const Judged& model : models) {
    parts.emplace_back(mode_table_of(
        data, {&model, 1}, fmt::format("{}, {}", caption, model.when)));
  }
}

std::string small_print(const Limits& limits, const Criteria& worst) {
  std::string text = updating::any_limit(limits)
                         ? "Limits are those of test.json."
                         : "No limits are set (\"limits\" in test.json).";
  if (worst.on_diagonal) {
    text +=
        " Cross-orthogonality is in the model's mass condensed to the measured "
        "points; where these are few it is large off the diagonal by itself.";
  }
  // Above that a shape may be more another mode's than its own.
  if (limits.cross_orthogonality.value_or(0.0) > std::sqrt(0.5)) {
    text += fmt::format(
        " A limit of {} off the diagonal is no test: that of a pair is "
        "\"cross_orthogonality_diagonal\".",
        number(*limits.cross_orthogonality));
  }
  return text;
}

/// A limit that is set, and what became of it in every measured mode.
struct Outcome {
  std::string limit;  ///< "MAC at least 0.9"
  std::size_t kept = 0;
  std::size_t broken = 0;
  std::string worst;  ///< "0.812 (mode 3)"
};

Outcome outcome_of(const Criterion& one,
                   const Judged& model,
                   const Limits& limits) {
  Outcome found;
  found.limit =
      fmt::format("{} {}{}", one.brief, number(*(limits.*one.limit)), one.unit);
  const std::optional<double>& worst = model.worst.*one.found;
  for (std::size_t k = 0; k < model.modes.size(); ++k) {
    const std::optional<bool> kept = keeps_one(one, model.modes[k], limits);
    if (!kept) continue;
    ++(*kept ? found.kept : found.broken);
    const double value = *(model.modes[k].*one.found);
    const bool is_worst = value == *worst || std::isnan(value);
    if (!is_worst || !found.worst.empty()) continue;
    found.worst = fmt::format("{} (mode {})", value_text(one, value), k + 1);
  }
  return found;
}

/// "Off the diagonal at most 0.1 is broken by 7 of 7 measured modes, 0.312
/// (mode 5) the worst."
std::string words_of(const Outcome& one, std::size_t modes) {
  const std::size_t tested = one.kept + one.broken;
  if (tested == 0) return capitalised(one.limit) + " is not tested.";
  const std::size_t count = one.broken > 0 ? one.broken : one.kept;
  return fmt::format("{} is {} by {} measured modes, {} the worst.",
                     capitalised(one.limit),
                     one.broken > 0 ? "broken" : "kept",
                     count == modes ? fmt::format("all {}", modes)
                                    : fmt::format("{} of {}", count, modes),
                     one.worst);
}

}  // namespace

std::string criteria_sentence(const ReportData& data) {
  const Limits& limits = data.notes.limits;
  if (!data.model || !updating::any_limit(limits)) return {};
  const auto models = all_judged(data);
  const Judged& now = models.back();
  std::vector<Outcome> outcomes;
  for (const Criterion& one : criteria) {
    if (limits.*one.limit) outcomes.push_back(outcome_of(one, now, limits));
  }
  std::ranges::stable_sort(
      outcomes, {}, [](const Outcome& one) { return one.broken == 0; });
  const auto verdict = now.tally.verdict();
  const std::size_t all = now.tally.modes;
  const auto of_all = [](const updating::Tally& t) {
    return t.kept == t.modes ? fmt::format("all {}", t.modes)
                             : fmt::format("{} of {}", t.kept, t.modes);
  };
  std::string text = fmt::format("Limits of the test: {}. ",
                                 !verdict   ? "not tested"
                                 : *verdict ? "pass"
                                            : "fail");
  for (const Outcome& one : outcomes) text += words_of(one, all) + " ";
  const auto paired = std::ranges::count(now.modes, true, &Criteria::paired);
  if (static_cast<std::size_t>(paired) < all) {
    text += fmt::format("{} of {} measured modes have a pair. ", paired, all);
  }
  text += fmt::format("Every limit is kept by {}", of_all(now.tally));
  if (models.size() > 1) {
    text += fmt::format(", before by {}", of_all(models.front().tally));
  }
  return text + ".";
}

std::vector<Part> criteria_parts(const ReportData& data) {
  const std::vector<Judged> models = all_judged(data);
  std::vector<Part> parts{
      worst_table(data, models),
      Paragraph{small_print(data.notes.limits, models.front().worst),
                Paragraph::Kind::Small}};
  add_mode_tables(data, models, parts);
  return parts;
}

}  // namespace tapfit::tui
