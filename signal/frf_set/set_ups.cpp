#include "signal/frf_set/set_ups.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace tapfit::signal {
namespace {

/// Channel, node and component of each sensor.
using Places = std::set<std::tuple<std::size_t, int, int>>;

bool one_holds_the_other(const Places& a, const Places& b) {
  return a.size() < b.size()
             ? std::includes(b.begin(), b.end(), a.begin(), a.end())
             : std::includes(a.begin(), a.end(), b.begin(), b.end());
}

}  // namespace

std::vector<std::size_t> set_ups(const FrfSet& frfs) {
  std::map<std::size_t, Places> of_run;
  for (const Frf& frf : frfs.frfs) {
    of_run[frf.run].insert(
        {frf.channel, frf.response.node, frf.response.component});
  }
  std::vector<Places> found;
  std::map<std::size_t, std::size_t> set_up;
  for (const auto& [run, places] : of_run) {
    const auto own = std::find_if(
        found.begin(), found.end(), [&places = places](const Places& other) {
          return one_holds_the_other(places, other);
        });
    set_up[run] = static_cast<std::size_t>(own - found.begin());
    if (own == found.end()) {
      found.push_back(places);
    } else if (own->size() < places.size()) {
      *own = places;
    }
  }
  std::vector<std::size_t> result;
  for (const Frf& frf : frfs.frfs) result.push_back(set_up.at(frf.run));
  return result;
}

}  // namespace tapfit::signal
