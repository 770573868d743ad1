// The room updating/effects. The catalogue of physical effects, one file for
// each, all by one interface.
// In:  Deck, bundle and a place.
// Out: Parameters with bounds, dynamic stiffness and its derivative, cards.
// May include: its row in CONTRIBUTING.md.
//
// What every effect of the catalogue must say of itself: where it may sit, on
// which degrees of freedom it acts, and its dynamic stiffness
//
//   Delta Z(s) = B D(s; p) B',   D = law(s; p) diag(weight)
//
// where B picks degrees of freedom of the base model.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/constants.hpp"
#include "updating/effects/change_kind.hpp"
#include "updating/places/between_grids.hpp"
#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"

#include <complex>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::effects {

using updating::Location;

struct Suspension;

/// What an effect needs to know to propose places, starts and bounds.
struct TestContext {
  const acquisition::TestBundle* bundle = nullptr;
  const structure::Deck* deck = nullptr;  ///< null for a test without a model
  double mass_kg = 1.0;                   ///< of the whole base model
  double low_hz = 1.0;                    ///< band
  double high_hz = 100.0;
  int component = 3;  ///< 1..3, the direction mostly measured
  /// 1..3: every direction in which something was measured or hit.
  std::vector<int> components = {};
  /// How a structure hangs that the model leaves free, where that is known and
  /// the measurement does not tell; else null.
  std::shared_ptr<const Suspension> suspension = nullptr;

  /// The band's ends [rad/s].
  [[nodiscard]] double low() const { return two_pi * low_hz; }
  [[nodiscard]] double high() const { return two_pi * high_hz; }
};

/// A positive parameter, fitted in its logarithm.
struct ParameterSpec {
  std::string name;  ///< result field, ends in its unit
  double start = 1.0;
  double lower = 0.0;
  double upper = 0.0;
  double sign = 1.0;  ///< -1: the value reported is the parameter's negative
};

/// One that starts in the middle of its bounds, as logarithms go.
[[nodiscard]] ParameterSpec spread(std::string name,
                                   double lower,
                                   double upper);

/// One degree of freedom that the effect acts on.
struct InterfaceDof {
  int node = 0;
  int component = 3;      ///< 1..6
  double weight = 1.0;    ///< factor on the law, for example a length
  std::size_t group = 0;  ///< which law, where an effect has several
  /// Between grids: what moves there; node and component are then the nearest.
  std::vector<updating::MotionShare> between = {};

  bool operator==(const InterfaceDof&) const = default;
};

/// How an effect enters the model.
enum class Entry {
  LowRank,      ///< through Woodbury, on free degrees of freedom
  Stiffness,    ///< a change of the base's stiffness matrix
  Measurement,  ///< in the channel, not in the structure
  Damping,      ///< of every mode, in place of a ratio for each
  Deck,         ///< in its numbers, before anything is assembled
};

/// What its places are.
enum class Sits {
  AtGrid,         ///< any that can move
  AlongAxis,      ///< the same, along one axis
  OnElements,     ///< of the model, by their ids
  OnLine,         ///< grids of a seam or of a support
  OnChannels,     ///< of sensors or hammers, told by their names
  AtSheetPoints,  ///< channels, at a grid there, in some runs or all
  Everywhere,
};

/// How its parameters enter the law of their group.
enum class Law {
  Spring,  ///< p
  Damper,  ///< s p
  Mass,    ///< s^2 p
  Own,     ///< as the effect says, or not at all: 1
};

/// What is the same of an effect at all its places.
struct EffectKind {
  std::string name;
  std::string words;             ///< in reports: "mass of the sensors"
  Entry entry = Entry::LowRank;  ///< Stiffness where it changes that
  Sits sits = Sits::Everywhere;
  Law law = Law::Spring;
  std::optional<updating::ChangeKind> changes_stiffness = std::nullopt;
  bool is_mistake = false;
  bool takes_any_grid = false;
  std::vector<std::string> forms = {};
  std::vector<std::string> variants = {};
};

/// 2 zeta omega of a mode [1/s], and its derivative by omega.
struct ModeDamping {
  double c = 0.0;
  double slope = 0.0;
};

/// What moves on a spring of its own, without its damper:
/// law = m w^2 s^2 / (s^2 + w^2).
struct Resonator {
  double mass = 0.0;   ///< m [kg]
  double omega = 0.0;  ///< w [rad/s]
};

class Effect {
 public:
  explicit Effect(EffectKind kind) : kind_(std::move(kind)) {}
  virtual ~Effect() = default;

  [[nodiscard]] const std::string& name() const { return kind_.name; }
  [[nodiscard]] const std::string& words() const { return kind_.words; }
  [[nodiscard]] Entry entry() const {
    return changes_stiffness() ? Entry::Stiffness : kind_.entry;
  }
  [[nodiscard]] Sits sits() const { return kind_.sits; }
  [[nodiscard]] bool sits_at_grid() const {
    return sits() == Sits::AtGrid || sits() == Sits::AlongAxis;
  }
  [[nodiscard]] bool at_sheet_points() const {
    return sits() == Sits::AtSheetPoints;
  }

  /// Whether it is a mistake of the set-up, sheet, channels or supports, not of
  /// the structure.
  [[nodiscard]] bool is_mistake() const {
    return kind_.is_mistake || entry() == Entry::Measurement || corrects_deck();
  }
  /// Whether it is a model of another deck: see correct_deck().
  [[nodiscard]] bool corrects_deck() const { return entry() == Entry::Deck; }

  /// Which, for Entry::Stiffness; its parameters scale the parts of that
  /// change.
  [[nodiscard]] std::optional<updating::ChangeKind> changes_stiffness() const {
    return kind_.changes_stiffness;
  }

  /// Every place where it may sit.
  [[nodiscard]] virtual std::vector<Location> places(
      const TestContext& context) const = 0;
  /// Whether `places` leave Where::node open, which may then be any grid but
  /// that of Where::nodes.
  [[nodiscard]] bool takes_any_grid() const { return kind_.takes_any_grid; }
  /// What Where::variant may be, where one is part of every place and none of
  /// the forms.
  [[nodiscard]] const std::vector<std::string>& variants() const {
    return kind_.variants;
  }
  /// Forms that it takes at its places only when asked for by name, or when the
  /// plain one has been found there; see Location::variant.
  [[nodiscard]] const std::vector<std::string>& forms() const {
    return kind_.forms;
  }
  /// Whether it can take one of its forms at one of its places.
  [[nodiscard]] virtual bool takes(const std::string& /*form*/,
                                   const Location& /*place*/,
                                   const TestContext& /*context*/) const {
    return true;
  }
  [[nodiscard]] virtual std::vector<ParameterSpec> parameters(
      const Location& /*where*/, const TestContext& /*context*/) const {
    return {};
  }

  /// Whether there are things of these sizes: each may be within its bounds and
  /// the two be none.
  [[nodiscard]] virtual bool is_plausible(
      const Location& /*where*/, const std::vector<double>& /*p*/) const {
    return true;
  }

  /// Degrees of freedom it acts on while one run is measured (a sensor's mass
  /// moves with the sensor). Those of Entry::LowRank alone.
  [[nodiscard]] virtual std::vector<InterfaceDof> interface_dofs(
      const Location& /*where*/,
      const TestContext& /*context*/,
      std::size_t /*run*/) const {
    return {};
  }

  /// For Entry::Measurement: turns the points and directions of a sheet into
  /// those that were hit and measured. What other mistakes have changed in it
  /// already stays as far as this one leaves it.
  /// @param written the sheet as it was written
  virtual void correct(const Location& /*where*/,
                       const acquisition::TestBundle& /*written*/,
                       acquisition::TestBundle& /*sheet*/) const {}

  /// For Entry::Deck: puts the numbers right. No model of the deck as it is
  /// holds that; its fits are those of the deck put right.
  virtual void correct_deck(const Location& /*where*/,
                            structure::Deck& /*deck*/) const {}

  /// For Entry::Measurement: the group of the law that FRFs go through whose
  /// response (or hammer) is on the channel.
  [[nodiscard]] virtual std::size_t passed_as(const Location&,
                                              bool hammer) const {
    return hammer ? 1 : 0;
  }

  /// For Entry::Damping: what a unit of parameter k gives a mode.
  [[nodiscard]] virtual ModeDamping mode_damping(double /*omega*/,
                                                 std::size_t /*k*/) const {
    return {};
  }

  /// law(s; p), in N/m (N m/rad for rotations) per unit weight; for
  /// Entry::Measurement the factor on the channel's FRFs. Parameter k is that
  /// of group k, but for Law::Own.
  [[nodiscard]] virtual std::complex<double> law(std::complex<double> s,
                                                 const std::vector<double>& p,
                                                 std::size_t group) const;
  /// d law / d p_k.
  [[nodiscard]] virtual std::complex<double> law_derivative(
      std::complex<double> s,
      const std::vector<double>& p,
      std::size_t group,
      std::size_t k) const;
  /// Whether parameter k adds p_k (stiffness_k + s^2 mass_k) to the law: a
  /// spring or a mass.
  [[nodiscard]] virtual bool is_lossless(std::size_t /*k*/) const {
    return kind_.law == Law::Spring || kind_.law == Law::Mass;
  }
  /// What the law is of where it has a motion of its own.
  [[nodiscard]] virtual std::optional<Resonator> resonator(
      const std::vector<double>& /*p*/) const {
    return std::nullopt;
  }
  /// Whether undamped frequencies and shapes tell of it: it changes stiffness
  /// or mass, and neither damps nor sits in a channel.
  [[nodiscard]] bool shows_in_modes() const {
    const bool point = entry() == Entry::LowRank && is_lossless(0);
    return point || changes_stiffness().has_value() || corrects_deck();
  }

  /// A derived result worth reporting besides the parameters themselves: the
  /// sum of factor_k p_k (for example per metre -> total).
  struct Derived {
    std::string name;
    std::vector<double> factors;  ///< one per parameter
  };
  [[nodiscard]] virtual std::vector<Derived> derived(const Location&,
                                                     const TestContext&) const {
    return {};
  }

  /// What its place alone says of its size, to be reported with the parameters.
  struct Fixed {
    std::string name;
    double value = 0.0;
  };
  [[nodiscard]] virtual std::vector<Fixed> fixed(const Location&) const {
    return {};
  }

  /// What its cards stand in for: these must come out of the deck's own
  /// constraints. Components along the grids' own axes.
  [[nodiscard]] virtual std::vector<structure::Constraint> released(
      const Location&, const TestContext&) const {
    return {};
  }

  /// Cards that put it into the deck; comments where bulk data has no card.
  [[nodiscard]] virtual std::vector<std::string> bulk_data(
      const Location& where,
      const TestContext& context,
      const std::vector<double>& p) const = 0;

 private:
  EffectKind kind_;
};

}  // namespace tapfit::effects
