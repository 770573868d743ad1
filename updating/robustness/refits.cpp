#include "updating/robustness/refits.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/diagnosis/made_fit.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <utility>

namespace tapfit::updating {
namespace {

bool same_place(const EffectInstance& a, const EffectInstance& b) {
  return a.effect == b.effect && a.where == b.where;
}

// All fits, each once, in the order of Refits.
std::vector<Fit*> all_of(Refits& refits) {
  std::vector<Fit*> fits{&refits.found};
  for (Fit& fit : refits.without) fits.push_back(&fit);
  for (std::vector<Contender>& rung : refits.instead) {
    for (std::size_t k = 1; k < rung.size(); ++k) {
      fits.push_back(&rung[k].hypothesis.fit);
    }
  }
  for (Contender& c : refits.besides) fits.push_back(&c.hypothesis.fit);
  return fits;
}

// Of each rung the first contender is what was found, its own effect last.
void take_found(Refits& refits) {
  for (std::vector<Contender>& rung : refits.instead) {
    Fit& fit = rung.front().hypothesis.fit;
    const EffectInstance own = fit.effects.back();
    fit = refits.found;
    const auto at = std::ranges::find_if(
        fit.effects,
        [&own](const EffectInstance& e) { return same_place(e, own); });
    if (at != fit.effects.end()) std::rotate(at, at + 1, fit.effects.end());
  }
}

/// Makes a fit anew.
/// @param position in all_of()
using Make =
    std::function<Fit(std::size_t position, const Fit&, const Progress&)>;

// All anew, on all cores. Only this thread reports; the others only listen for
// the stop.
void make_all(Refits& refits, const Make& make, const Progress& progress) {
  const std::vector<Fit*> fits = all_of(refits);
  const auto caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  for_each_parallel(fits.size(), [&](std::size_t k) {
    *fits[k] = make(k, *fits[k], {{}, progress.stop});
    ++done;
    if (std::this_thread::get_id() != caller) return;
    progress("how firm the verdict is",
             static_cast<double>(done) / static_cast<double>(fits.size()));
  });
  take_found(refits);
}

void take_out(std::vector<EffectInstance>& effects, const EffectInstance& one) {
  std::erase_if(effects,
                [&one](const EffectInstance& e) { return same_place(e, one); });
}

// A rival where it ended, beside the others: as they were beside it or, where
// they were not, as they are in what was found.
Fit beside(const Fit& rival, std::vector<EffectInstance> others) {
  for (EffectInstance& other : others) {
    for (const EffectInstance& e : rival.effects) {
      if (same_place(e, other)) other = e;
    }
  }
  Fit fit = rival;
  others.push_back(rival.effects.back());
  fit.effects = fit.result.state.effects = std::move(others);
  return fit;
}

Contender contending(const MadeFit& made, Fit fit) {
  Contender contender;
  contender.hypothesis.fit = std::move(fit);
  contender.hypothesis.places = made.places;
  contender.kind_share = made.kind_share;
  return contender;
}

// Where all of them start.
Refits starts(const Rivals& rivals, const effects::TestContext& context) {
  Refits refits;
  refits.found = where_it_ended(rivals.found, context);
  for (const std::vector<MadeFit>& tried : rivals.instead) {
    const Fit first = where_it_ended(tried.front(), context);
    Fit without = refits.found;
    take_out(without.effects, first.effects.back());
    without.result.state.effects = without.effects;
    std::vector<Contender> contenders{contending(tried.front(), first)};
    for (std::size_t k = 1; k < tried.size(); ++k) {
      contenders.push_back(contending(
          tried[k],
          beside(where_it_ended(tried[k], context), without.effects)));
    }
    refits.without.push_back(std::move(without));
    refits.instead.push_back(std::move(contenders));
  }
  for (const MadeFit& made : rivals.besides) {
    refits.besides.push_back(contending(
        made, beside(where_it_ended(made, context), refits.found.effects)));
  }
  return refits;
}

// Where a property is held it starts at the deck's value.
Fit start_under(const SettingChange& change, const Fit& from) {
  Fit start;
  start.effects = from.effects;
  start.result.state = from.result.state;
  for (const std::size_t k : change.of) {
    if (change.held) start.result.state.factor.at(k) = 1.0;
  }
  return start;
}

}  // namespace

Refits refits_of(const Rivals& rivals,
                 const Fitter& fitter,
                 const Progress& progress) {
  Refits refits = starts(rivals, fitter.problem().context);
  const std::size_t rungs = refits.without.size();
  make_all(
      refits,
      [&](std::size_t position, const Fit& start, const Progress& quiet) {
        const auto model = fitter.model_for(start.effects);
        // Without one of them it ends far from here.
        const bool without = position >= 1 && position <= rungs;
        return without ? fitter.fit(start.effects, model, quiet)
                       : fitter.fit_beside(start, start.effects, model, quiet);
      },
      progress);
  return refits;
}

Refits refits_under(const SettingChange& change,
                    const Refits& unchanged,
                    const Fitter& fitter,
                    const Progress& progress) {
  Refits refits = unchanged;
  if (!change.moves_fits()) {
    for (Fit* fit : all_of(refits)) {
      fit->form.allowance = fitter.problem().form_allowance;
    }
    take_found(refits);
    return refits;
  }
  make_all(
      refits,
      [&](std::size_t, const Fit& from, const Progress& quiet) {
        const Fit start = start_under(change, from);
        return fitter.fit_beside(start, start.effects, from.model, quiet);
      },
      progress);
  return refits;
}

}  // namespace tapfit::updating
