#include "tui/report/frf_text.hpp"

#include "signal/frf_set/measured_coherence.hpp"
#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

const char* word(signal::FrfForm form) {
  if (form == signal::FrfForm::Mobility) return "mobility";
  if (form == signal::FrfForm::Receptance) return "receptance";
  return "accelerance";
}

const char* unit(signal::FrfForm form) {
  if (form == signal::FrfForm::Mobility) return "(m/s)/N";
  if (form == signal::FrfForm::Receptance) return "m/N";
  return "(m/s^2)/N";
}

double mean_coherence(const signal::Frf& frf) {
  return frf.coherence.size() > 0 ? frf.coherence.mean() : 0.0;
}

// Of ready FRFs hits, scatter and coherence may be unknown.
std::vector<std::string> row_of(const signal::Frf& frf) {
  const double sd = median_sd_percent(frf);
  return {name(frf),
          fmt::format("{}", frf.run + 1),
          frf.hits > 0 ? fmt::format("{}", frf.hits) : "–",
          has_coherence(frf) ? fmt::format("{:.4f}", mean_coherence(frf)) : "–",
          sd > 0.0 ? percent(sd / 100.0) : "–"};
}

}  // namespace

double median_sd_percent(const signal::Frf& frf) {
  std::vector<double> percents;
  for (Eigen::Index line = 0; line < frf.variance.size(); ++line) {
    const double magnitude = std::abs(frf.H(line));
    if (magnitude > 0.0) {
      percents.push_back(100.0 * std::sqrt(frf.variance(line)) / magnitude);
    }
  }
  if (percents.empty()) return 0.0;
  const auto middle =
      percents.begin() + static_cast<std::ptrdiff_t>(percents.size() / 2);
  std::nth_element(percents.begin(), middle, percents.end());
  return *middle;
}

ordered_json frf_json(const signal::FrfSet& frfs, signal::FrfForm form) {
  ordered_json list = ordered_json::array();
  for (const auto& frf : frfs.frfs) {
    const double sd = median_sd_percent(frf);
    list.push_back({{"response", name(frf.response)},
                    {"reference", name(frf.reference)},
                    {"type", word(form)},
                    {"unit", unit(form)},
                    {"lines", frfs.lines()},
                    {"mean_coherence", nullptr},
                    {"median_sd_percent", nullptr},
                    {"run", frf.run + 1},
                    {"hits", frf.hits}});
    // What was not measured is null.
    ordered_json& told = list.back();
    if (has_coherence(frf)) told["mean_coherence"] = mean_coherence(frf);
    if (sd > 0.0) told["median_sd_percent"] = sd;
  }
  return {{"frfs", std::move(list)}, {"statements", frfs.statements}};
}

std::string frf_text(const signal::FrfSet& frfs, signal::FrfForm form) {
  std::string text = fmt::format("FRFs: {}", frfs.frfs.size());
  if (frfs.lines() > 0) {
    const Eigen::VectorXd hz = frfs.frequency_hz();
    text += fmt::format(", {} [{}] on {} lines, {:.4g} to {:.4g} Hz",
                        word(form),
                        unit(form),
                        frfs.lines(),
                        hz(0),
                        hz(hz.size() - 1));
    if (const double sigma = frfs.s(0).real(); sigma > 0.0) {
      text += fmt::format(", exponential window {:.3g} 1/s", sigma);
    }
  }
  TextTable table(
      {"<response / reference", "run", "hits", "coherence", "median sd"});
  for (const auto& frf : frfs.frfs) table.add(row_of(frf));
  text += "\n" + table.text();
  for (const auto& statement : frfs.statements) {
    text += "  note: " + statement + "\n";
  }
  return text;
}

}  // namespace tapfit::tui
