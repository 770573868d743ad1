#include "acquisition/instruments/sampling.hpp"

#include "acquisition/instruments/usual_names.hpp"
#include "acquisition/readers/time_units.hpp"
#include "acquisition/samples/rate_of_times.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

using Kind = NamedArray::Kind;

// How long two names are alike from their beginning.
std::size_t nearness(std::string_view one, std::string_view other) {
  return static_cast<std::size_t>(std::ranges::mismatch(one, other).in1 -
                                  one.begin());
}

// What belongs to one dataset says nothing of others.
bool may_tell(const NamedArray& array, std::string_view name) {
  const std::size_t at = array.name.find('@');
  if (at == std::string::npos) return true;
  const std::string_view owner = std::string_view(array.name).substr(0, at);
  return name == owner ||
         (name.starts_with(owner) &&
          std::string_view("/.:").find(name[at]) != std::string_view::npos);
}

// The nearest array of some kind.
template <class Fits>
const NamedArray* nearest(const std::vector<NamedArray>& all,
                          std::string_view name,
                          Fits fits) {
  const NamedArray* found = nullptr;
  for (const NamedArray& array : all) {
    if (array.kind != Kind::Numbers || !may_tell(array, name) || !fits(array)) {
      continue;
    }
    if (found == nullptr ||
        nearness(array.name, name) > nearness(found->name, name)) {
      found = &array;
    }
  }
  return found;
}

// A rate or step of one value.
std::optional<Sampling> stated(const std::vector<NamedArray>& all,
                               std::string_view name) {
  const NamedArray* found = nearest(all, name, [](const NamedArray& array) {
    const UsualName is = usual_name(array.name);
    return (is == UsualName::Rate || is == UsualName::Step) &&
           array.values.size() == 1 && array.values(0, 0) > 0.0 &&
           std::isfinite(array.values(0, 0));
  });
  if (found == nullptr) return std::nullopt;
  const double value = found->values(0, 0);
  const bool step = usual_name(found->name) == UsualName::Step;
  return Sampling{step ? 1.0 / value : value, std::nullopt};
}

// By the attribute that says what times are in.
double seconds_of(const std::vector<NamedArray>& all, const NamedArray& times) {
  for (const NamedArray& array : all) {
    if (array.kind == Kind::Text && array.texts.size() == 1 &&
        array.name.starts_with(times.name + "@") &&
        usual_name(array.name) == UsualName::Units) {
      return seconds_in(array.texts[0]).value_or(1.0);
    }
  }
  return 1.0;
}

// Times, one for each sample.
std::optional<Sampling> timed(const std::vector<NamedArray>& all,
                              std::string_view name,
                              Eigen::Index samples) {
  const NamedArray* found = nearest(all, name, [&](const NamedArray& array) {
    return usual_name(array.name) == UsualName::Time && array.columns() == 1 &&
           array.samples() == samples && array.name != name;
  });
  if (found == nullptr) return std::nullopt;
  const auto rate = rate_of_times(seconds_of(all, *found) * found->column(0));
  if (!rate || rate->uneven) return std::nullopt;
  return Sampling{rate->hz, rate->spread};
}

std::optional<Sampling> by_axis(const std::vector<NamedArray>& all,
                                std::string_view name,
                                Eigen::Index samples) {
  const NamedArray* found = nearest(all, name, [&](const NamedArray& array) {
    return array.columns() == 1 && array.samples() == samples &&
           array.name != name && is_axis(array.column(0));
  });
  if (found == nullptr) return std::nullopt;
  const auto rate = rate_of_times(found->column(0));
  if (rate->hz == 1.0) return std::nullopt;  // numbers of samples
  return Sampling{rate->hz, rate->spread};
}

}  // namespace

bool is_axis(const Eigen::VectorXd& values) {
  // Two values always lie on a line.
  const auto rate = values.size() > 2 ? rate_of_times(values) : std::nullopt;
  return rate && !rate->uneven;
}

std::optional<Sampling> sampling_of(const std::vector<NamedArray>& all,
                                    std::string_view name,
                                    Eigen::Index samples) {
  if (auto found = stated(all, name)) return found;
  if (auto found = timed(all, name, samples)) return found;
  return by_axis(all, name, samples);
}

}  // namespace tapfit::acquisition
