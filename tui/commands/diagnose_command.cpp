#include "tui/commands/diagnose_command.hpp"

#include "tui/commands/commands.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/effect_output.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/robustness_output.hpp"
#include "tui/report/text_table.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t candidates_shown = 10;
constexpr std::size_t kinds_shown = 3;

ordered_json candidate_json(const updating::Candidate& candidate) {
  const ordered_json own =
      placed_json("effect", candidate.effect, candidate.where);
  ordered_json others = ordered_json::array();
  for (const auto& other : candidate.indistinguishable_from) {
    ordered_json one = placed_json("effect", other.effect, other.where);
    if (one != own && std::ranges::find(others, one) == others.end()) {
      others.push_back(std::move(one));
    }
  }
  ordered_json json = own;
  json["probability"] = candidate.probability;
  json["parameters"] = parameters_json(candidate.parameters);
  json["error"] = candidate.error;
  json["indistinguishable_from"] = std::move(others);
  // Only those that came first were tried on runs left out.
  if (candidate.held_out_error > 0.0) {
    json["held_out_error"] = candidate.held_out_error;
  }
  return json;
}

ordered_json ladder_json(const std::vector<updating::Rung>& ladder) {
  ordered_json rungs = ordered_json::array();
  for (const auto& rung : ladder) {
    ordered_json json = placed_json("added", rung.added, rung.where);
    json["error"] = rung.error;
    json["parameters"] = parameters_json(rung.parameters);
    rungs.push_back(std::move(json));
  }
  return rungs;
}

ordered_json form_json(const updating::Diagnosis& diagnosis) {
  ordered_json list = ordered_json::array();
  for (const auto& form : diagnosis.model_form) {
    ordered_json where = ordered_json::object();
    if (form.property > 0) where["property"] = form.property;
    if (!form.elements.empty()) where["elements"] = form.elements;
    list.push_back({{"form", form.form},
                    {"where", std::move(where)},
                    {"share",
                     {{"value", form.share.value},
                      {"lo95", form.share.lo95},
                      {"hi95", form.share.hi95}}},
                    {"probability", form.probability},
                    {"error", form.error}});
    if (!form.card.empty()) list.back()["card"] = form.card;
  }
  return list;
}

ordered_json next_json(const updating::Diagnosis& diagnosis) {
  const auto effect = [](const updating::EffectRef& ref) {
    return placed_json("effect", ref.effect, ref.where);
  };
  ordered_json list = ordered_json::array();
  for (const auto& next : diagnosis.next) {
    list.push_back({{"between", {effect(next.one), effect(next.other)}},
                    {"hit", name(next.hit)},
                    {"channel", next.channel},
                    {"sensor", name(next.sensor)},
                    {"difference", next.difference},
                    {"difference_now", next.difference_now},
                    {"telling", is_significant(next, diagnosis.floor)}});
  }
  return list;
}

ordered_json set_up_json(const updating::Diagnosis& diagnosis) {
  ordered_json list = ordered_json::array();
  for (const auto& found : diagnosis.set_up) {
    ordered_json json = placed_json("mistake", found.mistake, found.where);
    json["probability"] = found.probability;
    json["error"] = found.error;
    json["edit"] = found.edit;
    list.push_back(std::move(json));
  }
  return list;
}

std::string next_text(const updating::Diagnosis& diagnosis) {
  std::string text;
  for (const auto& next : diagnosis.next) {
    text += fmt::format("  {} or {}? {}\n",
                        effect_text(next.one.effect, next.one.where),
                        effect_text(next.other.effect, next.other.where),
                        advice(next, diagnosis.floor));
  }
  return text;
}

std::string indented_parameters(
    const std::vector<updating::Estimate>& parameters) {
  std::string text;
  for (const auto& estimate : told(parameters)) {
    text += "      " + estimate_text(estimate) + "\n";
  }
  return text;
}

/// Effects of one kind, "joint at 12 places"; a single one with its place.
std::string of_one_kind(const std::vector<const updating::EffectRef*>& kind) {
  const updating::EffectRef& first = *kind.front();
  return kind.size() == 1
             ? effect_text(first.effect, first.where)
             : fmt::format("{} at {} places", first.effect, kind.size());
}

/// "or joint at 12 places, sensor-mass at acc1, 4 other kinds".
std::string indistinguishable(const updating::Candidate& candidate) {
  std::vector<std::vector<const updating::EffectRef*>> kinds;
  for (const updating::EffectRef& other : candidate.indistinguishable_from) {
    const auto same = std::ranges::find_if(kinds, [&other](const auto& kind) {
      return kind.front()->effect == other.effect;
    });
    if (same == kinds.end()) {
      kinds.push_back({&other});
    } else {
      same->push_back(&other);
    }
  }
  std::string text;
  for (std::size_t k = 0; k < std::min(kinds.size(), kinds_shown); ++k) {
    text += (text.empty() ? "or " : ", ") + of_one_kind(kinds[k]);
  }
  if (kinds.size() > kinds_shown) {
    const std::size_t more = kinds.size() - kinds_shown;
    text += fmt::format(", {} other kind{}", more, more == 1 ? "" : "s");
  }
  return text;
}

/// Three decimals, but never "0.000": what is small is not impossible.
std::string probability_text(double probability) {
  return probability < 0.0005 ? "<0.001" : fmt::format("{:.3f}", probability);
}

/// A table with one line per candidate, its size on the line below.
std::string candidates_text(const std::vector<updating::Candidate>& list) {
  if (list.empty()) return {};
  const std::size_t shown = std::min(list.size(), candidates_shown);
  TextTable table({"<candidate", "probability", "error", "<"});
  for (std::size_t k = 0; k < shown; ++k) {
    table.add({effect_text(list[k].effect, list[k].where),
               probability_text(list[k].probability),
               percent(list[k].error),
               indistinguishable(list[k])});
  }
  std::istringstream lines(table.text());
  std::string text;
  std::string line;
  std::getline(lines, line);
  text += line + "\n";
  for (std::size_t k = 0; k < shown; ++k) {
    std::getline(lines, line);
    text += line + "\n" + indented_parameters(list[k].parameters);
  }
  return text;
}

bool is_candidate(const updating::Diagnosis& diagnosis,
                  const updating::Rung& rung) {
  const std::string kind = leading_kind(rung);
  return std::ranges::any_of(
      diagnosis.candidates, [&](const updating::Candidate& candidate) {
        return candidate.effect == kind && candidate.where == rung.where;
      });
}

}  // namespace

ordered_json diagnosis_json(const std::filesystem::path& bundle,
                            const updating::Diagnosis& diagnosis) {
  ordered_json candidates = ordered_json::array();
  for (const auto& candidate : diagnosis.candidates) {
    candidates.push_back(candidate_json(candidate));
  }
  return {
      {"bundle", bundle.string()},
      {"verdict", diagnosis.verdict},
      {"error",
       {{"base", diagnosis.error_base},
        {"fitted", diagnosis.error_fitted},
        {"best", diagnosis.error_best},
        {"floor", diagnosis.floor},
        {"contour", diagnosis.contour}}},
      {"candidates", std::move(candidates)},
      {"ladder", ladder_json(diagnosis.ladder)},
      {"model_parameters", model_parameters_json(diagnosis.model_parameters)},
      {"model_form", form_json(diagnosis)},
      {"next_measurements", next_json(diagnosis)},
      {"set_up", set_up_json(diagnosis)},
      {"warnings", diagnosis.warnings}};
}

std::string diagnosis_text(const updating::Diagnosis& diagnosis) {
  return fmt::format("Diagnosis: {}\n", diagnosis.verdict) +
         findings_text(diagnosis);
}

std::string findings_text(const updating::Diagnosis& diagnosis) {
  std::string text = candidates_text(diagnosis.candidates);
  for (const auto& rung : diagnosis.ladder) {
    if (rung.parameters.empty() || is_candidate(diagnosis, rung)) continue;
    text += "  " + effect_text(rung.added, rung.where) + "\n" +
            indented_parameters(rung.parameters);
  }
  for (const auto& estimate : diagnosis.model_parameters) {
    text += fmt::format("  model parameter {}\n", estimate_text(estimate));
  }
  for (const auto& form : diagnosis.model_form) {
    text += "  " + statement(form) + "\n";
  }
  text += next_text(diagnosis);
  for (const auto& warning : diagnosis.warnings) {
    text += "  note: " + warning + "\n";
  }
  return text + "\n" + ladder_text(diagnosis);
}

std::string diagnose_command(const CommandOptions& options,
                             const Progress& progress) {
  updating::Session session = open_by_hand(options, progress);
  const updating::Diagnosis& diagnosis =
      options.robustness ? session.robust_diagnosis(progress)
                         : session.diagnosis(progress);
  if (!options.json) {
    return diagnosis_text(diagnosis) +
           (options.robustness ? "\n" + robustness_text(diagnosis.robustness)
                               : "");
  }
  ordered_json json =
      diagnosis_json(options.input, with_input_warnings(diagnosis, session));
  if (options.robustness) {
    json["robustness"] = robustness_json(diagnosis.robustness);
  }
  return json_text(json);
}

}  // namespace tapfit::tui
