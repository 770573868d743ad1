// The room updating/studies. Structures of the paper, solved as printed and by
// this program.
// Out: Tables of figures, to be set beside the published ones.
// May include: its row in CONTRIBUTING.md.
//
// A study of a deck whose properties are off by known amounts: exact FRFs of
// the true deck, with noise as told, and the model that is to find it. What a
// paper on model updating calls a simulated experiment.
//
//   H(s) = (K + s C + s^2 M)^-1,   C = a M + b K      (eq. 1 to 3, 32)
//   H_measured = H (1 + noise mu),   mu uniform in -1 .. 1
#pragma once

#include "acquisition/foundation/seeded_random.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "updating/frf_model/frf_model.hpp"

#include <Eigen/Core>

#include <filesystem>
#include <vector>

namespace tapfit::updating {

struct RayleighDamping {
  double a = 0.0;  ///< [1/s]
  double b = 0.0;  ///< [s]
};

/// A bundle without recordings that FRFs of these degrees of freedom belong
/// to: one run, response = reference.
class PropertyStudy {
 public:
  /// @param folder with a test.json that names the deck and what is uncertain
  /// @param points driving point FRFs are taken here
  /// @param reach_hz modes of its models up to here; residual flexibility
  ///   stands for the rest
  /// @throws InputError
  PropertyStudy(const std::filesystem::path& folder,
                const std::vector<Dof>& points,
                double reach_hz,
                const RayleighDamping& damping = {});
  // Its models point to the deck and the bundle.
  PropertyStudy(const PropertyStudy&) = delete;
  PropertyStudy& operator=(const PropertyStudy&) = delete;

  /// Accelerances of the deck with its uncertain properties scaled, by direct
  /// solution of the whole model.
  /// @param factor property over nominal, in the order of test.json
  /// @param s lines [rad/s]
  [[nodiscard]] signal::FrfSet exact(const std::vector<double>& factor,
                                     const Eigen::VectorXcd& s) const;

  /// The lowest natural frequencies [Hz], from the whole model.
  [[nodiscard]] Eigen::VectorXd frequencies_hz(
      const std::vector<double>& factor, Eigen::Index count) const;

  /// The model to update, its base solved at these factors: it is as exact as
  /// its modes reach there and less so the further its state moves away.
  [[nodiscard]] FrfModel model_at(const std::vector<double>& factor) const;

  /// A state of such a model with the damping of its modes there.
  /// @param factor over those that the model was made at
  [[nodiscard]] ModelState state(const FrfModel& model,
                                 const std::vector<double>& factor) const;

  [[nodiscard]] const structure::Deck& deck() const { return deck_; }
  [[nodiscard]] const acquisition::TestBundle& bundle() const {
    return bundle_;
  }
  [[nodiscard]] std::vector<double> nominal() const {
    return std::vector<double>(bundle_.uncertain.size(), 1.0);
  }

 private:
  [[nodiscard]] structure::Deck scaled(const std::vector<double>& factor) const;
  [[nodiscard]] signal::FrfSet empty_set(const Eigen::VectorXcd& s) const;

  acquisition::TestBundle bundle_;
  structure::Deck deck_;
  effects::TestContext context_;
  std::vector<Dof> points_;
  double reach_hz_;
  RayleighDamping damping_;
};

/// Lines on the imaginary axis, or on s = omega (delta + j).
[[nodiscard]] Eigen::VectorXcd lines_at(const Eigen::VectorXd& frequency_hz,
                                        double delta = 0.0);

/// H (1 + noise mu), and the variance that has.
void add_noise(signal::FrfSet& set,
               double noise,
               acquisition::SeededRandom& random);

}  // namespace tapfit::updating
