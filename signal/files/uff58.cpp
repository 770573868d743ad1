#include "signal/files/uff58.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/units.hpp"
#include "acquisition/foundation/utf8.hpp"
#include "acquisition/readers/mapped_file.hpp"
#include "acquisition/uff/uff_datasets.hpp"
#include "acquisition/uff/uff_function.hpp"
#include "acquisition/uff/uff_systems.hpp"
#include "acquisition/uff/uff_units.hpp"
#include "signal/files/finite_lines.hpp"
#include "signal/frf_set/convert.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace tapfit::signal {
namespace {

using acquisition::parse_number;
using acquisition::Quantity;
using acquisition::UffAxis;
using acquisition::UffDataset;
using acquisition::UffFunction;
using acquisition::UffUnits;

// Form and SI factor of an FRF; empty with a reason when it is none we can use.
struct Meaning {
  FrfForm form = FrfForm::Accelerance;
  double to_si = 1.0;
};

std::optional<FrfForm> form_of(const UffAxis& axis,
                               const std::optional<acquisition::Unit>& unit) {
  if (axis.type == 8) return FrfForm::Receptance;
  if (axis.type == 11) return FrfForm::Mobility;
  if (axis.type == 12) return FrfForm::Accelerance;
  if (axis.type > 1 || !unit) return std::nullopt;
  if (unit->quantity == Quantity::Acceleration) return FrfForm::Accelerance;
  if (unit->quantity == Quantity::Velocity) return FrfForm::Mobility;
  if (unit->quantity == Quantity::Displacement) return FrfForm::Receptance;
  return std::nullopt;
}

Quantity quantity_of(FrfForm form) {
  switch (form) {
    case FrfForm::Receptance:
      return Quantity::Displacement;
    case FrfForm::Mobility:
      return Quantity::Velocity;
    case FrfForm::Accelerance:
      break;
  }
  return Quantity::Acceleration;
}

// "m/s^2/N" in the numerator's label, as some programs write it, is both.
void split_ratio(UffAxis& over, UffAxis& under) {
  const std::size_t slash = over.unit.rfind('/');
  if (slash == std::string::npos || acquisition::find_unit(over.unit)) return;
  const std::string force = over.unit.substr(slash + 1);
  const auto unit = acquisition::find_unit(force);
  if (!unit || unit->quantity != Quantity::Force) return;
  if (!acquisition::is_unlabelled(under.unit) && under.unit != force) return;
  over.unit.resize(slash);
  under.unit = force;
}

std::string described(const UffAxis& axis) {
  return fmt::format(
      "\"{}\" (data type {})", acquisition::as_utf8(axis.unit), axis.type);
}

std::optional<Meaning> meaning(const UffFunction& function,
                               const UffUnits& factors,
                               std::string& reason) {
  UffAxis numerator = function.numerator;
  UffAxis denominator = function.denominator;
  split_ratio(numerator, denominator);
  const auto under = acquisition::find_unit(denominator.unit);
  const std::optional<FrfForm> form =
      form_of(numerator, acquisition::find_unit(numerator.unit));
  const bool by_force =
      denominator.type == 13 || denominator.type == 9 ||
      (denominator.type <= 1 && under && under->quantity == Quantity::Force);
  if (!function.response || !function.reference)
    reason = "its response or reference has no direction";
  else if (!form)
    reason = "its numerator is no motion: " + described(numerator);
  else if (!by_force)
    reason = "its denominator is no force: " + described(denominator);
  if (!reason.empty()) return std::nullopt;
  const Quantity motion = quantity_of(*form);
  const auto over_si = uff_unit_to_si(numerator.unit, motion, factors);
  const auto under_si =
      uff_unit_to_si(denominator.unit, Quantity::Force, factors);
  if (over_si && under_si) return Meaning{*form, *over_si / *under_si};
  reason = over_si ? no_uff_unit(denominator.unit, Quantity::Force)
                   : no_uff_unit(numerator.unit, motion);
  return std::nullopt;
}

// The number behind a key in an ID line: "SIGMA = 0.25 1/s".
std::optional<double> number_after(const std::string& line,
                                   std::string_view key) {
  const std::size_t at = line.find(key);
  if (at == std::string::npos) return std::nullopt;
  const std::size_t begin = at + key.size();
  const std::size_t end = std::min(line.find(' ', begin), line.size());
  double value = 0.0;
  const std::string_view text = line;
  if (!parse_number(text.substr(begin, end - begin), value) ||
      !std::isfinite(value))
    return std::nullopt;
  return value;
}

// The ID line has all digits, the 1858 eight.
double sigma_of(const UffFunction& function, double qualified) {
  for (const std::string& line : function.id)
    if (const auto sigma = number_after(line, "SIGMA = "))
      return std::max(*sigma, 0.0);
  return qualified;
}

Eigen::VectorXcd lines_of(const UffFunction& function, double qualified) {
  Eigen::VectorXd f = function.x;
  const auto first = number_after(function.id[4], "LINES = ");
  const auto step = number_after(function.id[4], " + n ");
  // Six digits of record 7 made exact, unless the line was edited.
  for (Eigen::Index i = 0; first && step && i < f.size(); ++i) {
    const double exact = *first + static_cast<double>(i) * *step;
    if (std::abs(exact - f(i)) <= 2e-5 * std::abs(exact)) f(i) = exact;
  }
  Eigen::VectorXcd s(f.size());
  s.real().setConstant(sigma_of(function, qualified));
  s.imag() = 2.0 * std::numbers::pi * f;
  return s;
}

bool same_lines(const Eigen::VectorXcd& a, const Eigen::VectorXcd& b) {
  return a.size() == b.size() &&
         (a - b).cwiseAbs().maxCoeff() <= 1e-5 * a.cwiseAbs().maxCoeff();
}

Eigen::Index count_bad(const Eigen::VectorXcd& H) {
  return H.size() - H.array().isFinite().count();
}

// What is left out is missing in all that follows.
void leave_out(std::string line, UffFrfs& result) {
  result.set.statements.push_back(line);
  result.skipped.push_back(std::move(line));
}

// The first few of many FRFs that are left out are enough.
void shorten(std::vector<std::string>& statements) {
  constexpr std::size_t enough = 4;
  if (statements.size() <= enough + 1) return;
  const std::size_t more = statements.size() - enough;
  statements.resize(enough);
  statements.push_back(fmt::format("{} more FRFs are left out", more));
}

// Dataset 1858: what the exponential window's decay rate was [1/s].
double window_damping(const UffDataset& dataset) {
  constexpr std::size_t record = 3;
  std::vector<double> values;
  if (dataset.lines.size() <= record ||
      !acquisition::numbers(dataset.lines[record], 15, values) ||
      values.size() < 5 || !std::isfinite(values[4]))
    return 0.0;
  return std::max(0.0, values[4]);
}

// The decay rate that a 1858 states for each dataset. They stand behind their
// function; in a file that begins with one, before it.
std::vector<double> window_dampings(const std::vector<UffDataset>& datasets) {
  std::vector<double> result(datasets.size(), 0.0);
  const auto first =
      std::find_if(datasets.begin(), datasets.end(), [](const UffDataset& d) {
        return d.type == 58 || d.type == 1858;
      });
  const bool ahead = first != datasets.end() && first->type == 1858;
  for (std::size_t k = 0; k < datasets.size(); ++k) {
    if (datasets[k].type != 1858) continue;
    const std::size_t of = ahead ? k + 1 : k - 1;
    if (of < datasets.size()) result[of] = window_damping(datasets[k]);
  }
  return result;
}

class Reader {
 public:
  /// @param geometry whose axes the file's directions count along; outlives it
  explicit Reader(const acquisition::UffGeometry& geometry)
      : geometry_(&geometry) {}

  /// @param sigma of the dataset's exponential window, where a 1858 says one
  void take(const UffDataset& dataset, double sigma) {
    sigma_ = sigma;
    if (dataset.type == 164) {
      factors_ = acquisition::read_uff_units(dataset);
      return;
    }
    constexpr std::array<int, 6> known = {151, 1858, 15, 2411, 18, 2420};
    if (std::ranges::find(known, dataset.type) != known.end()) return;
    if (dataset.type != 58)
      return skip(dataset, fmt::format("dataset {}", dataset.type));
    const int type = function_type(dataset);
    if (type == 4) return take_frf(dataset);
    if (type == 6) return coherences_.push_back(read_turned(dataset));
    skip(dataset, fmt::format("function type {}", type));
  }

  UffFrfs finish() {
    for (const UffFunction& function : coherences_) take_coherence(function);
    for (std::string& broken : leave_out_broken(result_.set)) {
      leave_out(std::move(broken), result_);
    }
    shorten(result_.set.statements);
    const std::string dropped = drop_bad_lines(result_.set);
    if (!dropped.empty()) leave_out(dropped, result_);
    return std::move(result_);
  }

 private:
  void skip(const UffDataset& dataset, const std::string& why) {
    result_.skipped.push_back(fmt::format("{}: {}", dataset.place, why));
  }

  void leave_out_frf(const UffDataset& dataset, const std::string& why) {
    leave_out(fmt::format("{}: an FRF is left out: {}", dataset.place, why),
              result_);
  }

  // With directions along global axes, or at points with axes of their own.
  [[nodiscard]] UffFunction read_turned(const UffDataset& dataset) const {
    UffFunction function = read_function(dataset);
    for (std::optional<Dof>* dof : {&function.response, &function.reference}) {
      if (*dof) *dof = acquisition::turned(*geometry_, **dof);
    }
    return function;
  }

  void take_frf(const UffDataset& dataset) {
    const UffFunction function = read_turned(dataset);
    std::string reason;
    const auto sense = meaning(function, factors_, reason);
    if (!sense) return leave_out_frf(dataset, reason);
    const Eigen::VectorXcd s = lines_of(function, sigma_);
    if (result_.set.frfs.empty()) result_.set.s = s;
    if (!same_lines(result_.set.s, s))
      return leave_out_frf(dataset, "its lines differ");
    Frf frf;
    frf.response = *function.response;
    frf.reference = *function.reference;
    frf.H = sense->to_si *
            convert(function.y, s, sense->form, FrfForm::Accelerance);
    // Its lines would be taken out of all others too.
    if (const Eigen::Index bad = count_bad(frf.H); 2 * bad > frf.H.size()) {
      return leave_out(
          fmt::format("{}: FRF {} is left out: {} of its {} values "
                      "are not finite",
                      dataset.place,
                      name(frf),
                      bad,
                      frf.H.size()),
          result_);
    }
    const auto number =
        references_.try_emplace(frf.reference, references_.size());
    frf.run = number.first->second;
    frf.coherence = Eigen::VectorXd::Ones(s.size());
    frf.variance = Eigen::VectorXd::Zero(s.size());
    result_.set.frfs.push_back(std::move(frf));
  }

  void take_coherence(const UffFunction& function) {
    for (Frf& frf : result_.set.frfs)
      if (function.response == frf.response &&
          function.reference == frf.reference &&
          function.y.size() == frf.H.size() && function.y.allFinite())
        frf.coherence = function.y.real().cwiseMax(0.0).cwiseMin(1.0);
  }

  const acquisition::UffGeometry* geometry_;
  UffFrfs result_;
  double sigma_ = 0.0;
  UffUnits factors_;
  std::vector<UffFunction> coherences_;
  std::map<Dof, std::size_t> references_;
};

}  // namespace

UffFrfs read_frfs_uff_text(std::string_view text, const std::string& name) {
  const std::vector<UffDataset> datasets = acquisition::split_uff(text, name);
  const acquisition::UffGeometry geometry =
      acquisition::read_geometry(datasets);
  Reader reader(geometry);
  const std::vector<double> sigma = window_dampings(datasets);
  for (std::size_t k = 0; k < datasets.size(); ++k)
    reader.take(datasets[k], sigma[k]);
  UffFrfs result = reader.finish();
  if (result.set.frfs.empty() || result.set.lines() == 0) {
    std::string found;
    for (const std::string& line : result.skipped) {
      if (found.size() > 200) break;
      found += (found.empty() ? "; it holds: " : "; ") + line;
    }
    throw InputError("the universal file holds no FRF (58, type 4)" + found,
                     name,
                     "export the FRFs as dataset 58, function type 4");
  }
  return result;
}

UffFrfs read_frfs_uff(const std::filesystem::path& file) {
  const acquisition::MappedFile bytes(file);
  return bytes.reading([&] {
    return read_frfs_uff_text(bytes.text(), file.filename().string());
  });
}

}  // namespace tapfit::signal
