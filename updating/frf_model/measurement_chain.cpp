#include "updating/frf_model/measurement_chain.hpp"

#include <algorithm>
#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using std::complex;

bool is_fault(const EffectInstance& placed) {
  return placed.effect->entry() == effects::Entry::Measurement;
}

bool same_points(const acquisition::Run& a, const acquisition::Run& b) {
  return a.hammer.dof == b.hammer.dof &&
         std::ranges::equal(a.sensors,
                            b.sensors,
                            {},
                            &acquisition::Placement::dof,
                            &acquisition::Placement::dof);
}

// One FRF through a channel at fault.
//
// @param first column of the effect's parameters in dH
// @param group of the effect's law, see Effect::passed_as()
void pass(const EffectInstance& placed,
          std::size_t first,
          std::size_t group,
          Index frf,
          const Eigen::VectorXcd& s,
          ModelResponse& out) {
  for (Index l = 0; l < s.size(); ++l) {
    const complex<double> gain = placed.effect->law(s(l), placed.p, group);
    for (MatrixXcd& d : out.dH) d(l, frf) *= gain;
    for (std::size_t p = 0; !out.dH.empty() && p < placed.p.size(); ++p) {
      out.dH[first + p](l, frf) =
          placed.p[p] *
          placed.effect->law_derivative(s(l), placed.p, group, p) *
          out.H(l, frf);
    }
    out.H(l, frf) *= gain;
  }
}

}  // namespace

bool is_passed_on(const effects::TestContext& context,
                  const std::vector<EffectInstance>& effects) {
  if (!is_fault(effects.back())) return false;
  const TestAsDone with = test_as_done(context, effects);
  const TestAsDone without =
      test_as_done(context, {effects.begin(), effects.end() - 1});
  return std::ranges::equal(
      with.context.bundle->runs, without.context.bundle->runs, same_points);
}

void apply_channel_effect(const std::vector<MeasuredPair>& pairs,
                          const EffectInstance& placed,
                          std::size_t first,
                          const Eigen::VectorXcd& s,
                          ModelResponse& out) {
  const std::vector<std::string>& channels = placed.where.channels;
  const auto faulty = [&channels](const std::string& name) {
    return std::find(channels.begin(), channels.end(), name) != channels.end();
  };
  const std::vector<int>& runs = placed.where.runs;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const int run = static_cast<int>(pairs[k].run) + 1;
    if (!runs.empty() && std::ranges::find(runs, run) == runs.end()) continue;
    const bool response = faulty(pairs[k].channel);
    if (!response && !faulty(pairs[k].hammer)) continue;
    pass(placed,
         first,
         placed.effect->passed_as(placed.where, !response),
         static_cast<Index>(k),
         s,
         out);
  }
}

void apply_chain(const std::vector<MeasuredPair>& pairs,
                 const ModalState& shared,
                 const Eigen::VectorXcd& s,
                 ModelResponse& out) {
  const ModelState& state = *shared.state;
  for (std::size_t e = 0; e < state.effects.size(); ++e) {
    const EffectInstance& placed = state.effects[e];
    if (!is_fault(placed)) continue;
    apply_channel_effect(pairs, placed, shared.first[e], s, out);
  }
}

}  // namespace tapfit::updating
