#include "updating/frf_model/recording_chain.hpp"

#include <algorithm>
#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using std::complex;

bool is_fault(const PlacedEffect& placed) {
  return placed.effect->entry() == effects::Entry::Measurement;
}

// One FRF through a channel at fault.
//
// @param first column of the effect's parameters in dH
// @param group of the effect's law, see Effect::passed_as()
void pass(const PlacedEffect& placed,
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

std::vector<Index> felt_responses(const std::vector<MeasuredPair>& pairs,
                                  const ModelState& state) {
  std::vector<Index> result;
  for (const MeasuredPair& pair : pairs) {
    std::string channel = pair.channel;
    for (const PlacedEffect& placed : state.effects) {
      if (is_fault(placed)) {
        channel = placed.effect->recorded_as(channel, placed.where);
      }
    }
    if (channel == pair.channel) {
      result.push_back(pair.response);
      continue;
    }
    const auto felt =
        std::find_if(pairs.begin(), pairs.end(), [&](const MeasuredPair& p) {
          return p.run == pair.run && p.channel == channel;
        });
    // Its own where the other one's FRF of that run was left out.
    result.push_back(felt == pairs.end() ? pair.response : felt->response);
  }
  return result;
}

bool is_passed_on(const std::vector<MeasuredPair>& pairs,
                  const PlacedEffect& placed) {
  return is_fault(placed) &&
         std::ranges::all_of(pairs, [&placed](const MeasuredPair& pair) {
           return placed.effect->recorded_as(pair.channel, placed.where) ==
                  pair.channel;
         });
}

void record_through(const std::vector<MeasuredPair>& pairs,
                    const PlacedEffect& placed,
                    std::size_t first,
                    const Eigen::VectorXcd& s,
                    ModelResponse& out) {
  const std::vector<std::string>& channels = placed.where.channels;
  const auto faulty = [&channels](const std::string& name) {
    return std::find(channels.begin(), channels.end(), name) != channels.end();
  };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
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

void record(const std::vector<MeasuredPair>& pairs,
            const ModalState& shared,
            const Eigen::VectorXcd& s,
            ModelResponse& out) {
  const ModelState& state = *shared.state;
  for (std::size_t e = 0; e < state.effects.size(); ++e) {
    const PlacedEffect& placed = state.effects[e];
    if (!is_fault(placed)) continue;
    record_through(pairs, placed, shared.first[e], s, out);
  }
}

}  // namespace tapfit::updating
