#include "updating/diagnosis/model_form.hpp"

#include "updating/fit/fitter.hpp"
#include "updating/properties/section_shear.hpp"
#include "updating/structure/deck/deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tapfit::updating {
namespace {

using structure::BarProperty;
using structure::Deck;

// Of ln f at 0 of the deck as it stands against what the data leave.
double savage_ratio(double t, double sd, double prior_sd) {
  return sd / prior_sd * std::exp(0.5 * t * t / (sd * sd));
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

}  // namespace

std::vector<ModelForm> model_form(const Fit& fit, const Deck& deck) {
  const std::vector<Correction>& known = fit.model->base().corrections;
  const std::vector<double>& factor = fit.result.state.factor;
  const auto shear = std::ranges::find(
      known, std::string_view(section_shear), &Correction::name);
  if (shear == known.end()) return {};
  const auto at = factor.size() - static_cast<std::size_t>(known.end() - shear);
  const auto k = static_cast<Eigen::Index>(at);
  const Eigen::MatrixXd& covariance = fit.result.covariance;
  const double variance = k < covariance.rows() ? covariance(k, k) : 0.0;
  const double t = std::log(factor.at(at));
  if (t <= 0.0 || !(variance > 0.0)) return {};
  const double ratio = savage_ratio(t, std::sqrt(variance), shear->sd);
  const double probability = std::isfinite(ratio) ? ratio / (1.0 + ratio) : 1.0;
  std::vector<ModelForm> found;
  if (probability <= 0.5) return found;
  for (const int id : shearless_sections(deck)) {
    const double k_shear = shear_coefficient(factor[at] - 1.0);
    found.push_back({shear->name,
                     id,
                     share_of(t, std::sqrt(variance)),
                     probability,
                     fit.result.error,
                     bar_card(deck.bar_properties.at(id), deck, k_shear)});
  }
  return found;
}

std::string statement(const ModelForm& form) {
  return fmt::format(
      "the deck's form: PBAR {} has no K1 and K2, so that its bars do not "
      "shear, but the structure does, {:.2g} ({:.2g} to {:.2g}) times as much "
      "as a solid section (p = {:.2f}); it is fitted along",
      form.property,
      form.share.value,
      form.share.lo95,
      form.share.hi95,
      form.probability);
}

}  // namespace tapfit::updating
