// What tests of the model's FRFs and modes share.
#pragma once

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/damped_line.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>

namespace tapfit::updating {

inline double difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  return (a - b).norm() / b.norm();
}

/// The sample plate with its fitter, and places of effects on it.
class PlateModel : public ::testing::Test, protected support::BasedPlate {
 protected:
  PlateModel()
      : s_(damped_line({10.0, 400.0}, 2.0, {0.05, 40})),
        pairs_(support::plate_pairs(bundle_, s_)) {
    FitProblem fit;
    fit.context = context_;
    fit.measured = pairs_;
    fit.targets = {make_target(pairs_)};
    fit.uncertain_sd = {0.03};
    fitter_.emplace(builder_, fit);
  }

  EffectInstance at_node(const std::string& name, int node, double p) const {
    Location where;
    where.node = node;
    return {&effects::find(name), where, {p}};
  }
  EffectInstance sensors(double m1, double m2) const {
    Location where;
    where.channels = {"acc1", "acc2"};
    where.variant = "each";
    return {&effects::find("sensor-mass"), where, {m1, m2}};
  }
  EffectInstance clamp(double k) const {
    const effects::Effect& effect = effects::find("soft-support");
    for (const Location& where : effect.places(context_)) {
      if (where.variant == "rotation") return {&effect, where, {k}};
    }
    throw std::logic_error("no clamp");
  }

  Eigen::VectorXcd s_;
  signal::FrfSet pairs_;
  std::optional<Fitter> fitter_;
};

}  // namespace tapfit::updating
