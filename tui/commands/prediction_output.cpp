#include "tui/commands/prediction_output.hpp"

#include "tui/report/effect_output.hpp"
#include "tui/report/text_table.hpp"
#include "updating/prediction/stated_change.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

using updating::PredictedMode;
using updating::Prediction;

/// Names and sizes of an effect, as its results have them.
ordered_json sized_json(const updating::EffectInstance& placed,
                        const effects::TestContext& context) {
  ordered_json json =
      placed_json("effect", placed.effect->name(), placed.where);
  ordered_json sizes = ordered_json::object();
  const auto specs = placed.effect->parameters(placed.where, context);
  for (std::size_t k = 0; k < specs.size() && k < placed.p.size(); ++k) {
    sizes[specs[k].name] = specs[k].sign * placed.p[k];
  }
  json["parameters"] = std::move(sizes);
  return json;
}

ordered_json sized_json(const std::vector<updating::EffectInstance>& all,
                        const effects::TestContext& context) {
  ordered_json list = ordered_json::array();
  for (const auto& placed : all) list.push_back(sized_json(placed, context));
  return list;
}

ordered_json mode_json(const PredictedMode& mode) {
  ordered_json json = {{"mode", mode.model + 1},
                       {"measured", nullptr},
                       {"measured_hz", nullptr},
                       {"measured_sd_hz", nullptr},
                       {"model_hz", mode.model_hz},
                       {"model_after_hz", mode.model_after_hz},
                       {"predicted_hz", estimate_json(mode.frequency_hz)},
                       {"change_hz", estimate_json(mode.change_hz)},
                       {"change_percent", estimate_json(mode.change_percent)},
                       {"damping_ratio_now", nullptr},
                       {"damping_ratio", nullptr},
                       {"mac", mode.mac}};
  if (mode.measured) {
    json["measured"] = *mode.measured + 1;
    json["measured_hz"] = mode.measured_hz;
    json["measured_sd_hz"] = mode.measured_sd_hz;
  }
  if (mode.damping_now) json["damping_ratio_now"] = *mode.damping_now;
  if (mode.damping_ratio) {
    json["damping_ratio"] = estimate_json(*mode.damping_ratio);
  }
  return json;
}

ordered_json frfs_json(const Prediction& prediction) {
  ordered_json list = ordered_json::array();
  for (std::size_t f = 0; f < prediction.frf_changes.size(); ++f) {
    const signal::Frf& frf = prediction.frfs.frfs.at(f);
    list.push_back({{"name", name(frf)},
                    {"run", frf.run + 1},
                    {"change", prediction.frf_changes[f].change},
                    {"sd", prediction.frf_changes[f].sd}});
  }
  return list;
}

const char* word_of(updating::Finding95 finding) {
  if (finding == updating::Finding95::Confirmed) return "confirmed";
  if (finding == updating::Finding95::Refuted) return "refuted";
  return "undecided";
}

/// So many that the interval's half width has two digits.
int decimals_of(const updating::Estimate& estimate) {
  constexpr int least = 2;
  constexpr int most = 6;
  if (!(estimate.sd > 0.0)) return most;
  const double digits = 1.0 - std::floor(std::log10(1.96 * estimate.sd));
  return static_cast<int>(std::clamp<double>(digits, least, most));
}

std::string value_text(const updating::Estimate& estimate) {
  return fmt::format("{:.{}f}", estimate.value, decimals_of(estimate));
}

std::string interval_text(const updating::Estimate& estimate) {
  const int decimals = decimals_of(estimate);
  return fmt::format(
      "{:.{}f} to {:.{}f}", estimate.lo95, decimals, estimate.hi95, decimals);
}

std::string predicted_modes_text(const std::vector<PredictedMode>& modes) {
  TextTable table({"mode",
                   "measured Hz",
                   "model Hz",
                   "predicted Hz",
                   "95 %",
                   "change Hz",
                   "95 %",
                   "change %",
                   "damping %"});
  for (const PredictedMode& mode : modes) {
    const std::string damping =
        mode.damping_ratio
            ? fmt::format("{:.2f}", 100.0 * mode.damping_ratio->value)
            : "-";
    table.add({fmt::format("{}", mode.model + 1),
               mode.measured ? fmt::format("{:.3f}", mode.measured_hz) : "-",
               fmt::format("{:.3f}", mode.model_hz),
               value_text(mode.frequency_hz),
               interval_text(mode.frequency_hz),
               value_text(mode.change_hz),
               interval_text(mode.change_hz),
               fmt::format("{:+.2f}", mode.change_percent.value),
               damping});
  }
  return modes.empty() ? "  the model has no mode in the band\n" : table.text();
}

std::string frfs_text(const Prediction& prediction) {
  const auto& changes = prediction.frf_changes;
  if (changes.empty()) return {};
  const auto most =
      std::ranges::max_element(changes, {}, &updating::FrfChange::change);
  const auto f = static_cast<std::size_t>(most - changes.begin());
  return fmt::format(
      "  FRFs change by {:.3g} % of their level at most ({}), known to "
      "{:.2g} %\n",
      100.0 * most->change,
      name(prediction.frfs.frfs.at(f)),
      100.0 * 1.96 * most->sd);
}

}  // namespace

ordered_json prediction_json(const Prediction& prediction) {
  const effects::TestContext& context = prediction.model->context();
  ordered_json modes = ordered_json::array();
  for (const PredictedMode& mode : prediction.modes) {
    modes.push_back(mode_json(mode));
  }
  return {{"with", sized_json(prediction.with, context)},
          {"change", sized_json(prediction.change, context)},
          {"form_sd", prediction.form_sd},
          {"modes", std::move(modes)},
          {"frfs", frfs_json(prediction)},
          {"warnings", prediction.warnings}};
}

ordered_json confirmation_json(const updating::Confirmation& confirmation,
                               const Prediction& prediction) {
  const auto& predicted = prediction.modes;
  ordered_json modes = ordered_json::array();
  for (const updating::ConfirmedMode& mode : confirmation.modes) {
    const auto& own = predicted.at(static_cast<std::size_t>(mode.predicted));
    modes.push_back({{"mode", own.model + 1},
                     {"measured", mode.measured + 1},
                     {"measured_hz", mode.measured_hz},
                     {"measured_sd_hz", mode.measured_sd_hz},
                     {"predicted_hz", own.frequency_hz.value},
                     {"deviation", mode.deviation},
                     {"mac", nullptr}});
    if (mode.has_shape) modes.back()["mac"] = mode.mac;
  }
  ordered_json unseen = ordered_json::array();
  for (const int m : confirmation.unseen) {
    unseen.push_back(predicted.at(static_cast<std::size_t>(m)).model + 1);
  }
  return {{"finding", word_of(confirmation.finding)},
          {"statement", statement(confirmation, prediction)},
          {"limit", confirmation.limit},
          {"modes", std::move(modes)},
          {"unseen", std::move(unseen)}};
}

std::string prediction_text(const Prediction& prediction,
                            const std::string& source) {
  const effects::TestContext& context = prediction.model->context();
  std::string text = "Predicted for\n";
  for (const auto& change : prediction.change) {
    text += "  " + change_text(change, context) + "\n";
  }
  text += "by the model with " + source + "\n";
  for (const auto& placed : prediction.with) {
    text += "  " + change_text(placed, context) + "\n";
  }
  text += predicted_modes_text(prediction.modes) + frfs_text(prediction);
  for (const std::string& warning : prediction.warnings) {
    text += "  note: " + warning + "\n";
  }
  return text;
}

std::string confirmation_text(const updating::Confirmation& confirmation,
                              const Prediction& prediction) {
  TextTable table(
      {"mode", "predicted Hz", "95 %", "measured Hz", "off by", "MAC"});
  for (const updating::ConfirmedMode& mode : confirmation.modes) {
    const auto& own =
        prediction.modes.at(static_cast<std::size_t>(mode.predicted));
    table.add({fmt::format("{}", own.model + 1),
               value_text(own.frequency_hz),
               interval_text(own.frequency_hz),
               fmt::format(
                   "{:.{}f}", mode.measured_hz, decimals_of(own.frequency_hz)),
               fmt::format("{:+.2f}", mode.deviation),
               mode.has_shape ? fmt::format("{:.3f}", mode.mac) : "-"});
  }
  std::string text =
      "Measured after the change, off by half widths of the "
      "95 % interval\n";
  if (!confirmation.modes.empty()) text += table.text();
  for (const int m : confirmation.unseen) {
    text += fmt::format(
        "  note: no measured mode is like that predicted at {:.6g} Hz\n",
        prediction.modes.at(static_cast<std::size_t>(m)).frequency_hz.value);
  }
  return text + statement(confirmation, prediction) + "\n";
}

}  // namespace tapfit::tui
