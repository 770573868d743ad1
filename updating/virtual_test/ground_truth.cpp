#include "updating/virtual_test/ground_truth.hpp"

#include "acquisition/foundation/output_file.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace tapfit::updating {
namespace {

using json = nlohmann::ordered_json;

json rounded(const Eigen::VectorXd& values, double steps) {
  json list = json::array();
  for (const double value : values) {
    list.push_back(std::round(value * steps) / steps);
  }
  return list;
}

// Totals of what the clamp has per metre.
void add_totals(const VirtualEffect& effect, double length, json& entry) {
  const auto total = [&](const char* name, double first, double last) {
    entry[name] = 0.5 * (first + last) * length;
  };
  const double one = effect.values.front();
  const double other = effect.values.back();
  const bool both = effect.form == "both";
  if (effect.form != "translation") {
    total("rotational_stiffness_nm_per_rad", one, both ? one : other);
  }
  if (!effect.form.empty()) {
    total("translational_stiffness_n_per_m", both ? other : one, other);
  }
}

json effects_json(const VirtualSetup& setup,
                  const VirtualStructure& structure) {
  json effects = json::array();
  for (const VirtualEffect& effect : structure.effects) {
    json entry = truth_entry(effect, setup.sensor_channels);
    if (effect.name == "soft-support") {
      add_totals(effect, structure.support_length, entry);
      entry["nodes"] = structure.support_nodes;
    }
    effects.push_back(entry);
  }
  return effects;
}

// As parse_virtual_effect() reads them.
json hidden_texts(const VirtualStructure& structure) {
  json texts = json::array();
  for (const VirtualEffect& effect : structure.effects) {
    texts.push_back(virtual_effect_text(effect));
  }
  return texts;
}

std::string joined_names(const VirtualStructure& structure) {
  std::string names;
  for (const VirtualEffect& effect : structure.effects) {
    names += (names.empty() ? "" : "+") + effect.name;
  }
  return names.empty() ? "none" : names;
}

}  // namespace

void write_ground_truth(const VirtualBundleSpec& spec,
                        const VirtualSetup& setup,
                        const VirtualStructure& structure,
                        const ReducedTruth& truth,
                        double modulus_factor,
                        const std::filesystem::path& file) {
  const auto& materials = setup.model.model.materials;
  json document{
      {"seed", spec.seed},
      {"structure", spec.structure},
      {"effect", joined_names(structure)},
      {"roving", spec.roving_sensor ? "sensor" : "hammer"},
      {"total_mass_kg", structure.total_mass},
      {"effects", effects_json(setup, structure)},
      {"natural_frequencies_hz", rounded(truth.frequency_hz, 1e4)},
      {"damping_ratio", rounded(truth.damping_ratio, 1e5)},
  };
  if (!materials.empty()) {
    document["E_true"] = materials.begin()->second.E * modulus_factor;
  }
  if (spec.sealed) {
    document["hidden"] = hidden_texts(structure);
    acquisition::write_file(
        file, sealed_text(document, file.parent_path()), {});
    return;
  }
  list_made_files(file.parent_path(), document);
  acquisition::write_file(file, document.dump(1) + '\n', {});
}

}  // namespace tapfit::updating
