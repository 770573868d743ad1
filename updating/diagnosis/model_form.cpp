#include "updating/diagnosis/model_form.hpp"

#include "updating/fit/fitter.hpp"
#include "updating/properties/line_mass.hpp"
#include "updating/properties/section_shear.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/mesh/stiff_corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tapfit::updating {
namespace {

using structure::BarProperty;
using structure::Deck;

// How likely 0 is before over how likely it is after.
double savage_ratio(double t, double sd, const Correction& before) {
  const double prior = before.mean / before.sd;
  const double posterior = t / sd;
  return sd / before.sd *
         std::exp(0.5 * (posterior * posterior - prior * prior));
}

Estimate share_of(double t, double sd) {
  return {"share",
          std::exp(t) - 1.0,
          std::exp(t) * sd,
          std::max(0.0, std::exp(t - 1.96 * sd) - 1.0),
          std::exp(t + 1.96 * sd) - 1.0};
}

// In the units of the file.
std::string bar_card(const BarProperty& p, const Deck& deck, double k) {
  const double length = deck.file_length_m;
  const double area = length * length;
  const double inertia = area * area;
  return fmt::format(
      "PBAR,{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},\n,,,,,,,,,\n"
      ",{:.4g},{:.4g},{:.6g}",
      p.id,
      p.material,
      p.area / area,
      p.I1 / inertia,
      p.I2 / inertia,
      p.J / inertia,
      p.nonstructural * length / deck.file_mass_kg,
      k,
      k,
      p.I12 / inertia);
}

// Twenty to one: strong evidence (R. E. Kass, A. E. Raftery, J. Am. Stat.
// Assoc. 90, 1995).
constexpr double clear = 20.0 / 21.0;

// What the data say of a form; nothing where they do not tell it from the deck
// as it stands.
std::optional<ModelForm> told(const Fit& fit, std::size_t correction) {
  const std::vector<Correction>& known = fit.model->base().corrections;
  const std::vector<double>& factor = fit.result.state.factor;
  const std::size_t at = factor.size() - known.size() + correction;
  const auto k = static_cast<Eigen::Index>(at);
  const Eigen::MatrixXd& covariance = fit.result.covariance;
  const double variance = k < covariance.rows() ? covariance(k, k) : 0.0;
  const double t = std::log(factor.at(at));
  if (t <= 0.0 || !(variance > 0.0)) return std::nullopt;
  const double sd = std::sqrt(variance);
  const double ratio = savage_ratio(t, sd, known[correction]);
  ModelForm form;
  form.form = known[correction].name;
  form.share = share_of(t, sd);
  form.probability = std::isfinite(ratio) ? ratio / (1.0 + ratio) : 1.0;
  form.error = fit.result.error;
  if (form.probability <= clear) return std::nullopt;
  return form;
}

}  // namespace

std::vector<ModelForm> model_form(const Fit& fit, const Deck& deck) {
  const std::vector<Correction>& known = fit.model->base().corrections;
  std::vector<ModelForm> found;
  for (std::size_t k = 0; k < known.size(); ++k) {
    const std::string& name = known[k].name;
    const bool corners = name == structure::corner_stiffness;
    if (!corners && name != section_shear && name != line_mass) continue;
    std::optional<ModelForm> form = told(fit, k);
    if (!form) continue;
    if (corners) {
      for (const auto& [id, share] : structure::inside_corners(deck)) {
        form->elements.push_back(id);
      }
    }
    if (name != section_shear) {
      found.push_back(*std::move(form));
      continue;
    }
    for (const int id : shearless_sections(deck)) {
      form->property = id;
      form->card = bar_card(deck.bar_properties.at(id),
                            deck,
                            shear_coefficient(form->share.value));
      found.push_back(*form);
    }
  }
  return found;
}

std::string statement(const ModelForm& form) {
  std::string what;
  if (form.form == section_shear) {
    what = fmt::format(
        "PBAR {} has no K1 and K2, so that its bars do not shear, but the "
        "structure does, as much as a solid section times",
        form.property);
  } else if (form.form == line_mass) {
    what =
        "bars have their mass on lines, but the structure's sections resist "
        "turning, and its material is there once where members meet; that "
        "times";
  } else {
    what =
        "members bend up to where their lines cross, but in the structure up "
        "to each other's face only; that stiffening times";
  }
  return fmt::format(
      "the deck's form: {} {:.2g} ({:.2g} to {:.2g}; p = {:.2f}); it is fitted "
      "along",
      what,
      form.share.value,
      form.share.lo95,
      form.share.hi95,
      form.probability);
}

}  // namespace tapfit::updating
