#include "signal/mass_removal/sensor_loads.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "signal/frf_set/set_ups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace tapfit::signal {
namespace {

/// Mass at each loaded grid of a set-up.
using MassAt = std::map<int, std::size_t>;

void place(const Frf& frf,
           const std::vector<ChannelMass>& masses,
           MassAt& mass_at) {
  const auto own =
      std::ranges::find(masses, frf.channel, &ChannelMass::channel);
  if (own == masses.end() || !(own->mass.kg > 0.0)) return;
  const auto index = static_cast<std::size_t>(own - masses.begin());
  const auto [at, fresh] = mass_at.try_emplace(frf.response.node, index);
  const KnownMass& first = masses[at->second].mass;
  if (!fresh && (first.kg != own->mass.kg || first.sd_kg != own->mass.sd_kg)) {
    throw InputError(
        fmt::format("{} and {} sit at one grid with different masses",
                    first.name,
                    own->mass.name),
        fmt::format("grid {}", node_name(frf.response.node)),
        "channels at one grid are taken as one sensor: give them one mass");
  }
}

}  // namespace

LoadedTest sensors_as_loads(const FrfSet& frfs,
                            const std::vector<ChannelMass>& masses) {
  LoadedTest loaded;
  for (const ChannelMass& own : masses) loaded.masses.push_back(own.mass);
  loaded.set_up = set_ups(frfs);
  std::map<std::size_t, MassAt> mass_at;
  for (std::size_t f = 0; f < frfs.frfs.size(); ++f) {
    place(frfs.frfs[f], masses, mass_at[loaded.set_up[f]]);
  }
  std::vector<std::set<Dof>> done(mass_at.size());
  loaded.loads.resize(mass_at.size());
  for (std::size_t f = 0; f < frfs.frfs.size(); ++f) {
    const std::size_t set_up = loaded.set_up[f];
    Dof dof = frfs.frfs[f].response;
    dof.sign = 1;
    const auto at = mass_at[set_up].find(dof.node);
    if (at == mass_at[set_up].end() || !done[set_up].insert(dof).second) {
      continue;
    }
    loaded.loads[set_up].push_back({at->second, dof});
  }
  return loaded;
}

LoadedTest points_as_loads(const FrfSet& frfs,
                           const std::vector<PointMass>& masses) {
  LoadedTest loaded;
  loaded.set_up.assign(frfs.frfs.size(), 0);
  loaded.loads.resize(1);
  for (const PointMass& own : masses) {
    Dof dof = own.dof;
    dof.sign = 1;
    if (own.mass.kg > 0.0) {
      loaded.loads[0].push_back({loaded.masses.size(), dof});
    }
    loaded.masses.push_back(own.mass);
  }
  return loaded;
}

}  // namespace tapfit::signal
