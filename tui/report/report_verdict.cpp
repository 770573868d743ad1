#include "tui/report/report_verdict.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"
#include "tui/widgets/bars.hpp"
#include "updating/comparison/compare.hpp"
#include "updating/diagnosis/worth.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

using updating::Rung;

/// As the diagnosis names it, with what is indistinguishable from it.
std::string rung_words(const ModelResults& model, const Rung& rung) {
  const Rung* found = diagnosed_rung(model, rung);
  const std::string own =
      with_article(found_words(found ? found->added : rung.added, rung.where));
  const bool named = found && found->added.find('|') != std::string::npos;
  if (!found || named || found->alike.empty()) return own;
  if (found->alike.size() > 1) {
    return fmt::format("{} or one of {} look-alikes", own, found->alike.size());
  }
  const updating::EffectRef& other = found->alike.front();
  return fmt::format(
      "{} or {}", own, with_article(found_words(other.effect, other.where)));
}

/// "falls from 14.5 % (15.3 % as delivered) to 0.75 %": what is uncertain in
/// the model is no effect's merit.
std::string fall_words(const ModelResults& model) {
  const double to = model.after.error;
  double from = model.before.error;
  for (const Rung& rung : model.ladder) {
    if (rung.added == updating::uncertain_rung) from = rung.error;
  }
  const bool fitted = from < model.before.error;
  const std::string was =
      fitted ? fmt::format(" ({} as delivered)", percent(model.before.error))
             : "";
  if (percent(from) == percent(to)) {
    return fmt::format("stays at {}{}", percent(to), was);
  }
  return fmt::format("{} from {}{} to {}",
                     to < from ? "falls" : "rises",
                     percent(from),
                     was,
                     percent(to));
}

/// What the diagnosis found and this model does not have.
std::vector<std::string> left_out_of(const ModelResults& model) {
  const std::vector<Rung> own = effect_rungs(model.ladder);
  std::vector<std::string> names;
  for (const Rung& found : model.diagnosis->ladder) {
    const bool there = std::ranges::any_of(own, [&](const Rung& rung) {
      return leading_kind(found) == rung.added && found.where == rung.where;
    });
    if (!there)
      names.push_back(with_article(found_words(found.added, found.where)));
  }
  return names;
}

/// How the error stands to the floor, as the end of a sentence.
std::string beside_floor(const updating::Comparison& now) {
  const std::string floor = percent(now.floor);
  if (now.error <= now.floor) {
    return fmt::format(
        "below what repeatability, mesh and form can resolve ({})", floor);
  }
  const bool near = now.error <= updating::at_floor * now.floor;
  return fmt::format("{} times what repeatability, mesh and form allow ({}){}",
                     times_floor(now.error, now.floor),
                     floor,
                     near ? ", as good as the measurement supports" : "");
}

/// What was measured, and is compared.
const char* data_words(const ReportData& data) {
  return data.bundle.modes ? "modes" : "FRFs";
}

std::string without_effects(const ReportData& data) {
  const ModelResults& model = *data.model;
  const char* of = data_words(data);
  const updating::Comparison& now = model.after;
  const bool unexplained =
      model.diagnosis && model.diagnosis->verdict == "unexplained";
  if (unexplained) {
    return fmt::format(
        "Something is missing from the model that no known effect explains: "
        "its {} are off by {}, {}.",
        of,
        percent(now.error),
        beside_floor(now));
  }
  const std::string was =
      model.before.error > now.error
          ? fmt::format(" ({} before what is uncertain in it was identified)",
                        percent(model.before.error))
          : "";
  if (!model.diagnosis) {
    return fmt::format(
        "The {} of the model are off by {}{}, {}; what may be missing from "
        "it has not been looked for.",
        of,
        percent(now.error),
        was,
        beside_floor(now));
  }
  if (model.diagnosis->verdict == updating::nonlinearity) {
    return fmt::format(
        "The structure behaves nonlinearly, which no linear model can hold; "
        "the model's {} are off by {}{}, {}.",
        of,
        percent(now.error),
        was,
        beside_floor(now));
  }
  if (updating::hides_errors(now.floor)) {
    return fmt::format(
        "Whether anything is missing from the model cannot be told: its {} are "
        "off by {}{}, and repeatability, mesh and form allow {}.",
        of,
        percent(now.error),
        was,
        percent(now.floor));
  }
  if (now.error <= updating::at_floor * now.floor) {
    return fmt::format(
        "Nothing significant is missing from the model: its {} are off by "
        "{}{}, {}.",
        of,
        percent(now.error),
        was,
        beside_floor(now));
  }
  return fmt::format(
      "No effect is supported by the data: the model's {} are off by {}{}, "
      "{}.",
      of,
      percent(now.error),
      was,
      beside_floor(now));
}

std::string with_effects(const ReportData& data,
                         const std::vector<Rung>& rungs) {
  const ModelResults& model = *data.model;
  std::vector<std::string> names;
  bool diagnosed = true;
  for (const Rung& rung : rungs) {
    names.push_back(rung_words(model, rung));
    diagnosed = diagnosed && diagnosed_rung(model, rung) != nullptr;
  }
  const std::string what = enumerated(names);
  const std::string errors = fmt::format("the error of the {} {}, {}",
                                         data_words(data),
                                         fall_words(model),
                                         beside_floor(model.after));
  if (!diagnosed) {
    return fmt::format("With what was added by hand ({}), {}.", what, errors);
  }
  if (model.diagnosis->verdict == "unexplained") {
    return fmt::format(
        "Something is missing from the model that no known effect explains; "
        "with what comes closest ({}), {}.",
        what,
        errors);
  }
  const bool nonlinear = model.diagnosis->verdict.find(
                             updating::nonlinearity) != std::string::npos;
  const std::vector<std::string> left_out = left_out_of(model);
  return fmt::format(
      "{} explain{} {}where model and measurement differ: with {}, {}{}{}.",
      capitalised(what),
      rungs.size() == 1 ? "s" : "",
      left_out.empty() ? "" : "part of ",
      rungs.size() == 1 ? "it" : "them",
      errors,
      left_out.empty()
          ? ""
          : fmt::format("; the diagnosis found {}, too, which {} not in this "
                        "model",
                        enumerated(left_out),
                        left_out.size() == 1 ? "is" : "are"),
      nonlinear ? "; the structure behaves nonlinearly, too" : "");
}

}  // namespace

std::vector<Rung> effect_rungs(const std::vector<Rung>& ladder) {
  std::vector<Rung> effects;
  std::ranges::copy_if(
      ladder, std::back_inserter(effects), [](const Rung& rung) {
        return rung.added != updating::base_rung &&
               rung.added != updating::uncertain_rung;
      });
  return effects;
}

const Rung* diagnosed_rung(const ModelResults& model, const Rung& rung) {
  if (!model.diagnosis) return nullptr;
  for (const Rung& found : model.diagnosis->ladder) {
    if (leading_kind(found) == rung.added && found.where == rung.where) {
      return &found;
    }
  }
  return nullptr;
}

bool is_diagnosed(const ModelResults& model) {
  if (!model.diagnosis) return false;
  const std::vector<Rung> own = effect_rungs(model.ladder);
  return own.size() == model.diagnosis->ladder.size() &&
         std::ranges::all_of(own, [&model](const Rung& rung) {
           return diagnosed_rung(model, rung) != nullptr;
         });
}

std::string verdict_sentence(const ReportData& data) {
  if (data.model) {
    const std::vector<Rung> rungs = effect_rungs(data.model->ladder);
    return rungs.empty() ? without_effects(data) : with_effects(data, rungs);
  }
  const auto& modes = data.modes.modes;
  if (modes.empty()) return "No mode was identified in the band.";
  return fmt::format(
      "{} mode{} {}, from {} to {} Hz; no model was given to compare with.",
      modes.size(),
      modes.size() == 1 ? " was" : "s were",
      data.bundle.modes ? "given" : "identified",
      four_digits(modes.front().frequency_hz),
      four_digits(modes.back().frequency_hz));
}

}  // namespace tapfit::tui
