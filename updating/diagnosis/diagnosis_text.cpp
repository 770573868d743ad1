#include "updating/diagnosis/diagnosis_text.hpp"

#include <nlohmann/json.hpp>

namespace tapfit {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Dof, node, component, sign)
}  // namespace tapfit

namespace tapfit::updating {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    Location, node, nodes, elements, channels, variant, at, runs)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    Estimate, name, value, sd, lo95, hi95, unit, at_bound)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EffectRef, effect, where, place_sd, start)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NextMeasurement,
                                   one,
                                   other,
                                   hit,
                                   sensor,
                                   channel,
                                   moves_sensor,
                                   difference,
                                   difference_now)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    SetUpMistake, mistake, where, probability, error, edit)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Candidate,
                                   effect,
                                   where,
                                   parameters,
                                   probability,
                                   error,
                                   held_out_error,
                                   indistinguishable_from,
                                   place_sd,
                                   sizes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rung,
                                   added,
                                   where,
                                   error,
                                   parameters,
                                   probability,
                                   alike,
                                   stopped_after,
                                   place_sd,
                                   sizes)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    MadeFit, effects, sizes, factor, zeta, zeta_other, places, kind_share)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Rivals, found, instead, besides)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    Robustness, change, verdict, verdict_stands, parameters, largest_move_sd)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(
    ModelForm, form, property, elements, share, probability, error, card)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Diagnosis,
                                   verdict,
                                   error_base,
                                   error_fitted,
                                   error_best,
                                   floor,
                                   form_sd,
                                   form_error,
                                   contour,
                                   candidates,
                                   ladder,
                                   model_parameters,
                                   model_form,
                                   next,
                                   set_up,
                                   warnings,
                                   rivals,
                                   robustness)

std::optional<std::string> as_text(const Diagnosis& diagnosis) {
  try {
    return nlohmann::json(diagnosis).dump();
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

std::optional<Diagnosis> diagnosis_from(std::string_view text) {
  try {
    return nlohmann::json::parse(text).get<Diagnosis>();
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace tapfit::updating
