#include "updating/places/bars_in_line.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Vector3d;
using structure::Bar;
using structure::Deck;

// Cosine of the sharpest turn within a member, 20 degrees.
constexpr double gentle = 0.94;

// A bar as it is walked along, from its grid `from` to the other one.
struct Step {
  const Bar* bar;
  std::size_t from;

  [[nodiscard]] int end() const { return bar->grids[1 - from]; }
};

class Members {
 public:
  explicit Members(const Deck& deck) : deck_(&deck) {
    for (const Bar& bar : deck.bars) {
      for (const std::size_t k : {0U, 1U})
        at_[bar.grids[k]].push_back({&bar, k});
    }
  }

  [[nodiscard]] std::optional<Step> after(const Step& step) const {
    std::optional<Step> next;
    double straightest = gentle;
    for (const Step& other : at_.at(step.end())) {
      if (other.bar == step.bar) continue;
      const double cosine = along(step).dot(along(other));
      if (cosine <= straightest) continue;
      straightest = cosine;
      next = other;
    }
    return next;
  }

 private:
  [[nodiscard]] Vector3d along(const Step& step) const {
    const auto position = [this](int grid) {
      return deck_->grid(grid).position;
    };
    return (position(step.end()) - position(step.bar->grids[step.from]))
        .normalized();
  }

  const Deck* deck_;
  std::map<int, std::vector<Step>> at_;  // those that begin at a grid
};

}  // namespace

std::vector<std::vector<int>> bars_in_line(const Deck& deck,
                                           std::size_t longest) {
  const Members members(deck);
  std::vector<std::vector<int>> runs;
  for (const Bar& bar : deck.bars) {
    for (const std::size_t from : {0U, 1U}) {
      std::vector<int> run = {bar.id};
      std::optional<Step> step = Step{&bar, from};
      while (run.size() < longest) {
        step = members.after(*step);
        // A ring comes back to where it began.
        if (!step || std::ranges::find(run, step->bar->id) != run.end()) break;
        run.push_back(step->bar->id);
        runs.push_back(run);
      }
    }
  }
  return runs;
}

std::vector<std::vector<int>> whole_runs(const Deck& deck) {
  const Members members(deck);
  std::set<int> used;
  std::vector<std::vector<int>> runs;
  for (const Bar& bar : deck.bars) {
    if (!used.insert(bar.id).second) continue;
    std::vector<int> run = {bar.id};
    for (const std::size_t from : {0U, 1U}) {
      Step here = {&bar, from};
      while (const std::optional<Step> next = members.after(here)) {
        // Back from the next one.
        const std::optional<Step> back =
            members.after({next->bar, 1 - next->from});
        if (!back || back->bar != here.bar) break;
        if (!used.insert(next->bar->id).second) break;
        run.push_back(next->bar->id);
        here = *next;
      }
    }
    std::ranges::sort(run);
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace tapfit::updating
