#include "tui/report/report_criteria.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"

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
using updating::ModePair;

using Found = std::optional<double> Criteria::*;
using Limit = std::optional<double> Limits::*;

/// One criterion: its value, its limit, and how both are written.
struct Criterion {
  Found found;
  Limit limit;
  bool at_least;  ///< otherwise at most
  int decimals;
  const char* unit;
  const char* words;  ///< at its worst
  const char* brief;  ///< in a sentence, before its limit
  const char* column;
};
constexpr std::array<Criterion, 4> criteria{
    {{&Criteria::frequency_percent,
      &Limits::frequency_percent,
      false,
      2,
      " %",
      "largest frequency error of a pair",
      "frequency within",
      "error"},
     {&Criteria::mac,
      &Limits::mac,
      true,
      3,
      "",
      "smallest MAC of a pair",
      "MAC at least",
      "MAC"},
     {&Criteria::on_diagonal,
      &Limits::cross_orthogonality_diagonal,
      true,
      3,
      "",
      "smallest cross-orthogonality of a pair",
      "cross-orthogonality on the diagonal at least",
      "cross-orth."},
     {&Criteria::off_diagonal,
      &Limits::cross_orthogonality,
      false,
      3,
      "",
      "largest cross-orthogonality off the diagonal",
      "cross-orthogonality off the diagonal at most",
      "off diagonal"}}};

/// What is no number keeps no limit.
bool within(const Criterion& one, double value, double limit) {
  return one.at_least ? value >= limit : value <= limit;
}

std::optional<bool> keeps_one(const Criterion& one,
                              const Criteria& mode,
                              const Limits& limits) {
  const std::optional<double>& limit = limits.*one.limit;
  const std::optional<double>& value = mode.*one.found;
  if (!limit || !value) return std::nullopt;
  return within(one, *value, *limit);
}

const char* judged_words(std::optional<bool> kept) {
  return !kept ? "not tested" : *kept ? "✓ pass" : "✗ fail";
}

std::string value_text(const Criterion& one,
                       const std::optional<double>& value) {
  return value ? fixed(*value, one.decimals) + one.unit : "–";
}

double cross(const Comparison& c, int measured, int model) {
  return std::sqrt(std::max(c.weighted_mac(measured, model), 0.0));
}

bool has_cross(const Comparison& c, const ModePair& pair) {
  return pair.has_shape && pair.measured < c.weighted_mac.rows() &&
         pair.model < c.weighted_mac.cols();
}

Criteria of_pair(const Comparison& c, const ModePair& pair) {
  Criteria found;
  found.paired = true;
  found.frequency_percent = std::abs(pair.error_percent);
  if (!pair.has_shape) return found;
  found.mac = pair.mac;
  if (!has_cross(c, pair)) return found;
  found.on_diagonal = cross(c, pair.measured, pair.model);
  for (const ModePair& other : c.pairs) {
    if (other.model == pair.model || !has_cross(c, other)) continue;
    found.off_diagonal = std::max(found.off_diagonal.value_or(0.0),
                                  cross(c, pair.measured, other.model));
  }
  return found;
}

/// One comparison, judged.
struct Judged {
  const Comparison* comparison = nullptr;
  const char* when = "model";  ///< or "before", "after"
  std::vector<Criteria> modes;
  Criteria worst;
  Tally tally;
};

Judged judged(const Comparison& comparison,
              const char* when,
              const ReportData& data) {
  const auto modes = criteria_of(comparison, data.modes.modes.size());
  const Tally counted = tally(modes, data.notes.limits);
  return {&comparison, when, modes, worst_of(modes), counted};
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
    if (any_limit(limits)) row.push_back(limit_words(one, limits));
    for (const Judged& model : models) {
      row.push_back(value_text(one, model.worst.*one.found));
      if (!any_limit(limits)) continue;
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
  const bool limited = any_limit(limits);
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
  const bool limited = any_limit(data.notes.limits);
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
  if (any_limit(limits)) row.emplace_back(judged_words(keeps(found, limits)));
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
    if (any_limit(limits)) table.heading.emplace_back("<");
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
  if (models.size() == 1 || !any_limit(data.notes.limits)) {
    parts.emplace_back(mode_table_of(data, models, caption));
    return;
  }
  for (const Judged& model : models) {
    parts.emplace_back(mode_table_of(
        data, {&model, 1}, fmt::format("{}, {}", caption, model.when)));
  }
}

std::string small_print(const Limits& limits, const Criteria& worst) {
  std::string text = any_limit(limits)
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

}  // namespace

std::vector<Criteria> criteria_of(const Comparison& comparison,
                                  std::size_t measured_modes) {
  std::vector<Criteria> found(measured_modes);
  for (const ModePair& pair : comparison.pairs) {
    const auto mode = static_cast<std::size_t>(pair.measured);
    if (mode < measured_modes) found[mode] = of_pair(comparison, pair);
  }
  return found;
}

Criteria worst_of(const std::vector<Criteria>& modes) {
  Criteria worst;
  worst.paired =
      !modes.empty() && std::ranges::all_of(modes, &Criteria::paired);
  for (const Criteria& mode : modes) {
    for (const Criterion& one : criteria) {
      const std::optional<double>& value = mode.*one.found;
      std::optional<double>& so_far = worst.*one.found;
      if (!value) continue;
      // What is no number is the worst and stays it.
      const bool lost = so_far && std::isnan(*so_far);
      if (!lost && !(so_far && within(one, *value, *so_far))) so_far = value;
    }
  }
  return worst;
}

bool any_limit(const Limits& limits) {
  return std::ranges::any_of(criteria, [&limits](const Criterion& one) {
    return (limits.*one.limit).has_value();
  });
}

std::optional<bool> keeps(const Criteria& mode, const Limits& limits) {
  if (!any_limit(limits)) return std::nullopt;
  if (!mode.paired) return false;
  std::optional<bool> kept = true;
  for (const Criterion& one : criteria) {
    if (!(limits.*one.limit)) continue;
    const std::optional<bool> this_one = keeps_one(one, mode, limits);
    if (this_one == false) return false;
    if (!this_one) kept.reset();
  }
  return kept;
}

std::optional<bool> Tally::verdict() const {
  if (failed == 0 && (modes == 0 || kept < modes)) return std::nullopt;
  return failed == 0;
}

Tally tally(const std::vector<Criteria>& modes, const Limits& limits) {
  Tally found{.modes = modes.size()};
  for (const Criteria& mode : modes) {
    const std::optional<bool> kept = keeps(mode, limits);
    found.kept += kept == true ? 1 : 0;
    found.failed += kept == false ? 1 : 0;
  }
  return found;
}

std::string criteria_sentence(const ReportData& data) {
  const Limits& limits = data.notes.limits;
  if (!data.model || !any_limit(limits)) return {};
  std::vector<std::string> set;
  for (const Criterion& one : criteria) {
    const std::optional<double>& limit = limits.*one.limit;
    if (!limit) continue;
    set.push_back(fmt::format("{} {}{}", one.brief, number(*limit), one.unit));
  }
  const std::string text = "The limits of the test (" + enumerated(set) + ")";
  const auto models = all_judged(data);
  const Tally& now = models.back().tally;
  const auto verdict = now.verdict();
  const Tally& was = models.front().tally;
  std::string before;
  if (models.size() > 1)
    before = fmt::format(", before by {} of {}", was.kept, was.modes);
  return fmt::format(
      "{} are kept by {} {} measured modes{}: {}.",
      text,
      now.kept == now.modes ? "all" : fmt::format("{} of", now.kept),
      now.modes,
      before,
      !verdict   ? "not tested"
      : *verdict ? "pass"
                 : "fail");
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
