#include "updating/measurement/ready_frfs.hpp"

#include "modal/mass_loading/sensor_shifts.hpp"
#include "updating/measurement/bundle_frfs.hpp"
#include "updating/measurement/default_identification.hpp"
#include "updating/measurement/frf_runs.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

/// Grids of the responses, in the order of the file.
std::vector<int> places_of(const signal::FrfSet& set) {
  std::vector<int> places;
  for (const signal::Frf& frf : set.frfs) {
    if (std::ranges::count(places, frf.response.node) == 0) {
      places.push_back(frf.response.node);
    }
  }
  return places;
}

/// The FRFs of a few places from all over the file.
signal::FrfSet sample(const signal::FrfSet& set,
                      const std::vector<int>& places) {
  constexpr std::size_t few = 4;
  std::set<int> kept;
  for (std::size_t k = 0; k < few; ++k) {
    kept.insert(places[k * (places.size() - 1) / (few - 1)]);
  }
  signal::FrfSet part;
  part.s = set.s;
  std::ranges::copy_if(
      set.frfs, std::back_inserter(part.frfs), [&kept](const signal::Frf& frf) {
        return kept.contains(frf.response.node);
      });
  return part;
}

ReadyFrfs laid_out(signal::FrfSet set,
                   acquisition::TestBundle& bundle,
                   Sensors sensors,
                   const Progress& progress) {
  lay_out_runs(set, bundle, sensors);
  std::optional<modal::ModeSet> modes =
      default_identification(set, bundle.band_hz, progress);
  return {std::move(set), std::move(modes)};
}

bool move_with_the_mass(const modal::ModeSet& modes) {
  return modes.shifts && modes.shifts->cause == modal::ShiftCause::SensorMass;
}

/// With a sensor that moved, where that leaves less than half of what all
/// having stayed does, or the poles move as its mass moves them. As little left
/// by fewer poles is not enough: of two close modes each place shows one.
std::optional<ReadyFrfs> laid_out_as_moved(const signal::FrfSet& set,
                                           acquisition::TestBundle& bundle,
                                           const modal::ModeSet& stayed,
                                           const Progress& progress) {
  ReadyFrfs moved = laid_out(set, bundle, Sensors::Moved, progress);
  if (!moved.modes || moved.modes->set_ups.empty()) return std::nullopt;
  const bool clearly =
      moved.modes->synthesis_error <= 0.5 * stayed.synthesis_error;
  if (!clearly && !move_with_the_mass(*moved.modes)) return std::nullopt;
  return moved;
}

/// Where a few places show nothing, all of them are not tried: each takes an
/// identification of its own.
std::optional<ReadyFrfs> moved_frfs(const signal::FrfSet& set,
                                    acquisition::TestBundle& bundle,
                                    const modal::ModeSet& stayed,
                                    const Progress& progress) {
  constexpr double perfect = 1e-3;  // less than any measurement scatters
  const std::vector<int> places = places_of(set);
  if (places.size() < 2 || stayed.synthesis_error < perfect) {
    return std::nullopt;
  }
  acquisition::TestBundle trial = bundle;
  const bool some =
      laid_out_as_moved(sample(set, places), trial, stayed, progress)
          .has_value();
  return some ? laid_out_as_moved(set, bundle, stayed, progress) : std::nullopt;
}

}  // namespace

ReadyFrfs read_ready_frfs(acquisition::TestBundle& bundle,
                          const Progress& progress) {
  ReadyFrfs stayed =
      laid_out(read_bundle_frfs(bundle).set, bundle, Sensors::Stayed, progress);
  acquisition::TestBundle moving = bundle;
  std::optional<ReadyFrfs> moved =
      stayed.modes ? moved_frfs(stayed.set, moving, *stayed.modes, progress)
                   : std::nullopt;
  if (moved) {
    bundle = std::move(moving);
    moved->set.statements.emplace_back(
        "the FRFs came ready: which sensor was where is not in the file, but "
        "their poles differ from point to point, so that one sensor counts as "
        "moved over all response points");
    return *std::move(moved);
  }
  stayed.set.statements.emplace_back(
      "the FRFs came ready: which sensor was where is not in the file, so that "
      "each response point counts as a sensor that stayed there");
  return stayed;
}

}  // namespace tapfit::updating
