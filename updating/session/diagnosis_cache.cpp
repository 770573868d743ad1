#include "updating/session/diagnosis_cache.hpp"

#include "acquisition/foundation/input_file.hpp"
#include "updating/cache/content_digest.hpp"
#include "updating/cache/program_stamp.hpp"
#include "updating/diagnosis/diagnosis_text.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

template <class Numbers>
void add_numbers(const Numbers& numbers, ContentDigest& digest) {
  digest.add(std::string_view(
      reinterpret_cast<const char*>(numbers.data()),
      static_cast<std::size_t>(numbers.size()) * sizeof(*numbers.data())));
}

void add(const acquisition::TestBundle& bundle, ContentDigest& digest) {
  digest.add(acquisition::read_input(bundle.folder / "test.json"));
  for (const acquisition::Channel& channel : bundle.channels) {
    digest.add(channel.name);
    digest.add(channel.mass_kg.value_or(-1.0));
  }
  for (const std::string& warning : bundle.warnings) digest.add(warning);
  for (const acquisition::TestPoint& point : bundle.points) {
    for (const double number : {static_cast<double>(point.label),
                                static_cast<double>(point.node),
                                static_cast<double>(point.system),
                                point.height_m}) {
      digest.add(number);
    }
    if (point.at) add_numbers(*point.at, digest);
    add_numbers(point.axes, digest);
  }
  if (!bundle.geometry) return;
  for (const auto& [label, x] : bundle.geometry->nodes) {
    digest.add(static_cast<double>(label));
    add_numbers(x, digest);
  }
}

void add(const structure::Deck& deck, ContentDigest& digest) {
  digest.add(deck.path.filename().string());  // in messages
  digest.add(deck.file_length_m);
  digest.add(deck.file_mass_kg);
  for (const std::string& card : deck.cards) digest.add(card);
  if (!deck.given) return;
  digest.add(deck.given->K);
  digest.add(deck.given->M);
  for (const structure::Grid& grid : deck.grids) {
    digest.add(static_cast<double>(grid.id));
    add_numbers(grid.position, digest);
  }
}

void add(const signal::FrfSet& set, ContentDigest& digest) {
  add_numbers(set.s, digest);
  for (const signal::Frf& frf : set.frfs) {
    digest.add(name(frf));
    digest.add(static_cast<double>(frf.run));
    digest.add(static_cast<double>(frf.channel));
    add_numbers(frf.H, digest);
    add_numbers(frf.variance, digest);
  }
}

void add(const modal::ModeSet& modes, ContentDigest& digest) {
  for (const Dof& dof : modes.dofs) digest.add(name(dof));
  for (const modal::Mode& mode : modes.modes) {
    digest.add(mode.pole.real());
    digest.add(mode.pole.imag());
    add_numbers(mode.shape, digest);
    digest.add(mode.frequency_sd_hz);
    add_numbers(mode.shape_sd, digest);
  }
}

void add(const std::vector<PairByHand>& pairs, ContentDigest& digest) {
  for (const PairByHand& pair : pairs) {
    digest.add(pair.measured_hz);
    digest.add(static_cast<double>(pair.model));
  }
}

void add(const EffectRef& effect, ContentDigest& digest) {
  digest.add(effect.effect);
  digest.add(static_cast<double>(effect.where.node));
  digest.add(effect.where.nodes);
  digest.add(effect.where.elements);
  digest.add(static_cast<double>(effect.where.channels.size()));
  for (const std::string& channel : effect.where.channels) digest.add(channel);
  digest.add(effect.where.variant);
  digest.add(static_cast<double>(effect.where.at.size()));
  for (const double x : effect.where.at) digest.add(x);
  digest.add(effect.where.runs);
}

void add(const EffectHistory& history,
         std::size_t effects,
         ContentDigest& digest) {
  std::size_t taken = 0;
  for (const AddedEffect& added : history.now) {
    if (!added.on || taken++ >= effects) continue;
    add(added.ref, digest);
  }
  for (const EarlyStoppedFit& fit : history.kept) {
    if (fit.effects.size() > effects) continue;
    digest.add("fit ended by hand");
    for (const EffectRef& effect : fit.effects) add(effect, digest);
    digest.add(static_cast<double>(fit.steps));
  }
}

// The cache keeps matrices: one number per character.
MatrixXd as_matrix(const std::string& text) {
  MatrixXd matrix(static_cast<Index>(text.size()), 1);
  std::ranges::copy(text, matrix.data());
  return matrix;
}

}  // namespace

DiagnosisCache::DiagnosisCache(std::optional<MatrixCache> cache,
                               const DiagnosisContent& content,
                               const EffectHistory& history,
                               std::size_t effects) {
  const std::optional<std::string> stamp = program_stamp();
  if (!cache || !stamp) return;
  cache_ = std::move(cache);
  ContentDigest digest;
  digest.add("diagnosis");
  digest.add(*stamp);
  add(content.bundle, digest);
  add(content.deck, digest);
  add(content.frfs, digest);
  add(content.modes, digest);
  // Fits to FRFs do not ask which mode is which.
  if (content.bundle.modes) add(content.pairs, digest);
  add(history, effects, digest);
  key_ = digest.digest();
}

std::optional<Diagnosis> DiagnosisCache::load() const {
  if (!cache_) return std::nullopt;
  const auto kept = cache_->load(key_);
  if (!kept || kept->size() != 1) return std::nullopt;
  std::string text;
  for (const double character : kept->front().reshaped()) {
    text += static_cast<char>(character);
  }
  return diagnosis_from(text);
}

void DiagnosisCache::keep(const Diagnosis& diagnosis) const {
  const std::optional<std::string> text = as_text(diagnosis);
  if (cache_ && text) cache_->store(key_, {as_matrix(*text)});
}

Diagnosis DiagnosisCache::kept_or_made(
    const std::function<Diagnosis()>& make) const {
  if (std::optional<Diagnosis> kept = load()) return *std::move(kept);
  Diagnosis diagnosis = make();
  keep(diagnosis);
  return diagnosis;
}

}  // namespace tapfit::updating
