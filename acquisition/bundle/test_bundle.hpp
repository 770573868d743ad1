// The room acquisition/bundle. The test bundle: who measured what where, and
// the recordings in SI.
// In:  A folder with a test.json and sound files, or one universal file.
// Out: TestBundle, and one Recording per run. Hits are sought further on.
// May include: its row in CONTRIBUTING.md.
//
// The test bundle: a folder with a test.json that says what was measured where
// and with what. The format is described in docs/test-bundle.md and checked
// against docs/test.schema.json.
#pragma once

#include "acquisition/bundle/channel.hpp"
#include "acquisition/bundle/test_geometry.hpp"
#include "acquisition/bundle/test_point.hpp"
#include "acquisition/foundation/dof.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// A channel at a point of the structure.
struct Placement {
  std::size_t channel = 0;  ///< index into TestBundle::channels
  Dof dof;
};

/// A channel's samples in a universal file.
struct UffSource {
  std::size_t channel = 0;  ///< index into TestBundle::channels
  std::size_t dataset = 0;  ///< which one of the file
  double unit_to_si = 1.0;
};

/// One recording: one hammer, any number of sensors, one or more hits.
struct Run {
  std::filesystem::path file;  ///< absolute, or relative to the working folder
  std::vector<UffSource> datasets;  ///< of a universal file; else empty
  Placement hammer;
  std::vector<Placement> sensors;
};

/// A property of the base model that the engineer does not trust.
struct UncertainProperty {
  std::string card;      ///< "material" or "property"
  int id = 0;            ///< MAT1 or PSHELL/PBAR/... id
  std::string property;  ///< "E", "rho", "t", ...
  double sd_percent = 3.0;
};

/// K and M from another program instead of a deck.
struct MatrixModel {
  std::filesystem::path stiffness;
  std::filesystem::path mass;
  std::filesystem::path dofs;
};

/// The article as it was weighed, without sensors.
struct Weighed {
  double mass_kg = 0.0;
  std::optional<std::array<double, 3>> centre_m;  ///< in the model's basic axes
  double sd_percent = 1.0;                        ///< of the mass
};

/// Ready modes: what the test consists of in place of recordings or FRFs.
struct ReadyModes {
  std::filesystem::path file;  ///< UFF 55 or 2414, CSV or JSON
  /// Standard deviations where the file gives none [%]: of a frequency, and of
  /// a shape's values, of their root mean square.
  double frequency_sd_percent = 0.2;
  double shape_sd_percent = 5.0;
};

/// How hits are triggered. What is empty is chosen, and stated.
struct TriggerOptions {
  std::optional<double> range_percent;  ///< level, of the hammer's full scale
  std::optional<int> slope;             ///< 1: blows rise in the file; -1: fall
  /// Armed again once the force is below this share of the level [%].
  std::optional<double> rearm_percent;
  std::optional<double> hold_off_s;  ///< a later pulse is a hit of its own
};

struct TestBundle {
  std::filesystem::path folder;
  std::filesystem::path file;  ///< test.json, or the universal file
  std::string title;
  std::string units = "SI";  ///< "SI", "mm-t-s" or "in-lbf-s"
  /// Names of the deck's cards that are left out, though it needs them.
  std::vector<std::string> ignored_cards;
  std::optional<std::filesystem::path> deck;  ///< Nastran bulk data
  std::optional<MatrixModel> matrices;
  std::vector<Channel> channels;
  std::vector<Run> runs;
  /// Of the test's own: what degrees of freedom below node 0 mean.
  std::vector<TestPoint> points;
  /// The test's mesh, where nodes have numbers of its own.
  std::optional<TestGeometry> geometry;
  std::optional<std::filesystem::path> frfs;  ///< ready FRFs (UFF 58)
  std::optional<ReadyModes> modes;
  std::optional<std::filesystem::path> uff;  ///< the bundle is this file alone
  std::optional<std::array<double, 2>> band_hz;
  std::optional<Weighed> weighed;
  /// Highest of the rigid-body modes as the structure hung [Hz].
  std::optional<double> suspension_hz;
  std::vector<UncertainProperty> uncertain;
  std::optional<double> trigger_percent;  ///< of the hammer's largest peak
  TriggerOptions trigger;
  std::optional<double> pre_trigger_s;
  std::optional<double> block_s;
  std::vector<std::string> warnings;  ///< unknown fields and the like
};

}  // namespace tapfit::acquisition
