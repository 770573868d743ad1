// Which recordings of one test a file of arrays holds: channels whose names
// repeat are the same channels, recorded again.
//
//   run1/force, run1/acc, run2/force, ...   groups, structures, TDMS groups
//   force{1}, acc{1}, force{2}, ...         cells, structures of several
//   elements run1_force, force_run2                  keys run1, run2, each
//   samples x channels     arrays with columns force, acc, each runs x samples
//   arrays with an axis of runs
//
// Groups without a hammer in each are no runs but sensors of one recording.
#pragma once

#include "acquisition/instruments/time_record.hpp"
#include "acquisition/readers/named_array.hpp"

#include <string>
#include <vector>

namespace tapfit::acquisition {

struct FileRun {
  std::string name;  ///< of its group; empty where the file is one recording
  std::vector<TimeRecord> records;
};

struct FileRuns {
  /// At least one; all with the same channels in the same order, by the names
  /// of the first. Their lengths may differ.
  std::vector<FileRun> runs;
  /// Arrays that may be records and are in no run, with the reason.
  std::vector<std::string> left_out;
  /// Why it cannot be told whether the file holds several runs; it is then
  /// taken as one. Empty where it can.
  std::string doubt;
};

[[nodiscard]] FileRuns runs_of_arrays(const std::vector<NamedArray>& all);

}  // namespace tapfit::acquisition
