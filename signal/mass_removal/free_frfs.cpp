#include "signal/mass_removal/free_frfs.hpp"

#include "signal/mass_removal/mass_removal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace tapfit::signal {
namespace {

/// Finds accelerances of the loaded structure, measured or modelled.
class Entries {
 public:
  Entries(const FrfSet& frfs, const LoadedTest& loaded, const FrfModel& model)
      : frfs_(&frfs), loaded_(&loaded), model_(&model) {
    for (std::size_t f = 0; f < frfs.frfs.size(); ++f) {
      const Frf& frf = frfs.frfs[f];
      measured_.try_emplace(key(loaded.set_up[f], frf.response, frf.reference),
                            f);
    }
  }

  [[nodiscard]] LoadedEntry measured(std::size_t f) const {
    const Frf& frf = frfs_->frfs[f];
    const int sign = frf.response.sign * frf.reference.sign;
    return {&frf.H, &frf.variance, static_cast<double>(sign), f};
  }

  /// A_ab; says in `missing` what was not measured.
  std::optional<LoadedEntry> find(std::size_t set_up,
                                  const Dof& a,
                                  const Dof& b,
                                  std::string& missing) {
    for (const Key& wanted : {key(set_up, a, b), key(set_up, b, a)}) {
      const auto own = measured_.find(wanted);
      if (own != measured_.end()) return measured(own->second);
    }
    if (missing.empty()) missing = name(a) + " / " + name(b);
    return modelled(set_up, a, b);
  }

 private:
  using Key = std::tuple<std::size_t, int, int, int, int>;
  struct Modelled {
    std::optional<ModelledFrf> frf;
    std::size_t source = 0;
  };

  static Key key(std::size_t set_up, const Dof& a, const Dof& b) {
    return {set_up, a.node, a.component, b.node, b.component};
  }

  std::optional<LoadedEntry> modelled(std::size_t set_up,
                                      const Dof& a,
                                      const Dof& b) {
    if (!*model_) return std::nullopt;
    const Key wanted = std::min(key(set_up, a, b), key(set_up, b, a));
    auto own = modelled_.find(wanted);
    if (own == modelled_.end()) {
      const std::size_t source = frfs_->frfs.size() + modelled_.size();
      own = modelled_.emplace(wanted, Modelled{(*model_)(set_up, a, b), source})
                .first;
    }
    if (!own->second.frf) return std::nullopt;
    const ModelledFrf& frf = *own->second.frf;
    return LoadedEntry{&frf.H, &frf.variance, 1.0, own->second.source};
  }

  const FrfSet* frfs_;
  const LoadedTest* loaded_;
  const FrfModel* model_;
  std::map<Key, std::size_t> measured_;
  std::map<Key, Modelled> modelled_;
};

Dof positive(Dof dof) {
  dof.sign = 1;
  return dof;
}

/// Collects what freeing one FRF takes.
class Collector {
 public:
  Collector(Entries& entries, std::size_t set_up)
      : entries_(&entries), set_up_(set_up) {}

  void add(std::vector<LoadedEntry>& into, const Dof& a, const Dof& b) {
    if (!complete_) return;
    const std::optional<LoadedEntry> entry =
        entries_->find(set_up_, a, b, missing_);
    complete_ = entry.has_value();
    if (entry) into.push_back(*entry);
  }
  [[nodiscard]] bool complete() const { return complete_; }
  /// The first that was not measured; empty when all were.
  [[nodiscard]] const std::string& missing() const { return missing_; }

 private:
  Entries* entries_;
  std::size_t set_up_;
  bool complete_ = true;
  std::string missing_;
};

void set_masses(const LoadedTest& loaded,
                const std::vector<Load>& loads,
                MassRemoval& removal) {
  removal.kg.resize(static_cast<Eigen::Index>(loads.size()));
  removal.sd_kg.resize(removal.kg.size());
  Eigen::Index t = 0;
  for (const Load& load : loads) {
    removal.kg(t) = loaded.masses[load.mass].kg;
    removal.sd_kg(t) = loaded.masses[load.mass].sd_kg;
    removal.mass.push_back(load.mass);
    ++t;
  }
}

/// Frees one FRF in place.
FreedNote free_frf(const LoadedTest& loaded,
                   std::size_t f,
                   Entries& entries,
                   Frf& frf) {
  const std::size_t set_up = loaded.set_up[f];
  const std::vector<Load>& loads = loaded.loads[set_up];
  if (loads.empty()) return {FreedBy::NoNeed, {}};
  const Dof i = positive(frf.response);
  const Dof j = positive(frf.reference);
  MassRemoval removal;
  removal.wanted = entries.measured(f);
  set_masses(loaded, loads, removal);
  Collector collector(entries, set_up);
  for (const Load& load : loads) {
    for (const Load& other : loads) {
      collector.add(removal.core, load.dof, other.dof);
    }
    collector.add(removal.row, i, load.dof);
    collector.add(removal.column, load.dof, j);
  }
  if (!collector.complete()) {
    return {FreedBy::NotFreed,
            fmt::format("{} was not measured in this set-up and is not known "
                        "from the modes",
                        collector.missing())};
  }
  const std::optional<FreedCurve> freed = remove_masses(removal);
  if (!freed) {
    return {FreedBy::NotFreed,
            "without the masses nothing would be left to move at some line: "
            "they are too large"};
  }
  frf.H = removal.wanted.sign * freed->H;
  frf.variance = freed->variance;
  if (collector.missing().empty()) return {FreedBy::Measurement, {}};
  return {
      FreedBy::Model,
      fmt::format("{} was not measured in this set-up", collector.missing())};
}

}  // namespace

FreedFrfs free_frfs(const FrfSet& frfs,
                    const LoadedTest& loaded,
                    const FrfModel& model,
                    const Progress& progress) {
  FreedFrfs result{frfs, {}};
  Entries entries(frfs, loaded, model);
  const auto count = static_cast<double>(frfs.frfs.size());
  for (std::size_t f = 0; f < frfs.frfs.size(); ++f) {
    progress("FRFs: freeing", static_cast<double>(f) / count);
    result.notes.push_back(free_frf(loaded, f, entries, result.frfs.frfs[f]));
  }
  return result;
}

}  // namespace tapfit::signal
