// What the Diagnose screen is drawn from.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "tui/widgets/plot_range.hpp"
#include "tui/widgets/table.hpp"
#include "tui/widgets/wireframe.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/localisation/localisation_map.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/structure/deck/deck.hpp"

#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace tapfit::tui {

/// What is shown: the diagnosis of the model, what it has tried so far, or that
/// of the model before.
enum class Standing { Final, Preliminary, Outdated };

struct DiagnoseInput {
  const acquisition::TestBundle& bundle;
  const updating::Diagnosis& diagnosis;
  const std::map<int, std::shared_ptr<const updating::Signature>>& signatures;
  const Wireframe* wire = nullptr;
  /// How well each grid alone explains what is missing, once it is known.
  const std::vector<updating::GridShare>* map = nullptr;
  Standing standing = Standing::Final;
  const structure::Deck* deck = nullptr;  ///< for where elements are
};

struct DiagnoseState {
  ListState list;  ///< candidates
  /// To be added together; also such as are not in the list (any more).
  std::vector<updating::EffectRef> tagged;
  PlotRange range;  ///< [Hz], of the signature
  Pose pose;
  bool map = false;       ///< all grids instead of the candidate's place
  bool all_laws = false;  ///< mass, spring and dashpot, not the best alone
  /// All in words, from that line on, in place of table and plots.
  std::optional<int> details = {};
  /// How firm the verdict is, likewise.
  std::optional<int> firmness = {};
};

}  // namespace tapfit::tui
