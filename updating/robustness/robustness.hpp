// The room updating/robustness. How firm a verdict is.
// In:  A diagnosis, and the fitter it was made with.
// Out: For each thing that was assumed what becomes of verdict and sizes when
// it
//      is changed.
// May include: its row in CONTRIBUTING.md.
//
// Whether a verdict stands, and how far its sizes move, when something that was
// assumed is changed. The diagnosis is not made again: what it found and what
// came closest (Rivals) are fitted anew from where they were, and compared by
// the same evidence. An explanation that it never fitted is not found here.
#pragma once

#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/robustness/refits.hpp"
#include "updating/robustness/setting_change.hpp"

#include <vector>

namespace tapfit::updating {

class FirmnessCheck {
 public:
  /// Fits with nothing changed.
  /// @param fitter, diagnosis must outlive it
  /// @param options that the diagnosis was made with
  /// @throws Stopped
  FirmnessCheck(const Fitter& fitter,
                const DiagnoseOptions& options,
                const Diagnosis& diagnosis,
                const Progress& progress);

  /// @throws Stopped
  [[nodiscard]] Robustness under(const SettingChange& change,
                                 const Progress& progress) const;

 private:
  const Fitter* fitter_;
  DiagnoseOptions options_;
  const Diagnosis* diagnosis_;
  Refits unchanged_;
};

/// All changes, one after the other; before them that nothing was changed,
/// where even so the verdict falls.
/// @throws Stopped
[[nodiscard]] std::vector<Robustness> robustness(const Fitter& fitter,
                                                 const DiagnoseOptions& options,
                                                 const Diagnosis& diagnosis,
                                                 const Progress& progress);

}  // namespace tapfit::updating
