#include "signal/checks/exchanged_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace tapfit::signal {
namespace {

using acquisition::TestBundle;

/// What each FRF is taken for, as FrfSet::frfs.
struct Labels {
  std::vector<Dof> response;
  std::vector<Dof> reference;

  [[nodiscard]] double sign(std::size_t f) const {
    return response[f].sign * reference[f].sign;
  }
};

bool at_one(const Dof& a, const Dof& b) {
  return a.node == b.node && a.component == b.component;
}

bool is_alike(const Reciprocal& pair) {
  return pair.fair() || pair.by_a_factor();
}

Labels labels_of(const FrfSet& set) {
  Labels labels;
  for (const Frf& frf : set.frfs) {
    labels.response.push_back(frf.response);
    labels.reference.push_back(frf.reference);
  }
  return labels;
}

// Where that channel sits, or what was hit, in the set-up of a run.
std::optional<Dof> dof_of(const FrfSet& set,
                          bool hits,
                          std::size_t channel,
                          std::size_t run) {
  for (const Frf& frf : set.frfs) {
    if (frf.run != run || (!hits && frf.channel != channel)) continue;
    return hits ? frf.reference : frf.response;
  }
  return {};
}

// Empty where the two do not stand in one run.
std::optional<Labels> exchanged(const FrfSet& set,
                                const ExchangedLabels& exchange) {
  Labels labels = labels_of(set);
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    const Frf& frf = set.frfs[f];
    if (!is_of(exchange, frf)) continue;
    const std::size_t own = exchange.hits ? frf.run : frf.channel;
    const std::size_t to = own == exchange.one ? exchange.other : exchange.one;
    const std::optional<Dof> dof =
        dof_of(set, exchange.hits, to, exchange.hits ? to : frf.run);
    if (!dof) return {};
    (exchange.hits ? labels.reference : labels.response)[f] = *dof;
  }
  return labels;
}

bool is_driving_point(const FrfSet& set, std::size_t f, double sign) {
  const DrivingPoint point = driving_point(set, f, sign);
  return point.fair() || point.wrong_peaks == point.peaks;
}

// All that is known of the FRFs with another label.
bool holds(const FrfSet& set,
           const Labels& labels,
           const ExchangedLabels& exchange) {
  int paths = 0;
  for (std::size_t i = 0; i < set.frfs.size(); ++i) {
    if (!is_of(exchange, set.frfs[i])) continue;
    if (at_one(labels.response[i], labels.reference[i])) {
      if (!is_driving_point(set, i, labels.sign(i))) return false;
      continue;
    }
    for (std::size_t j = 0; j < set.frfs.size(); ++j) {
      if (j == i || !at_one(labels.response[i], labels.reference[j]) ||
          !at_one(labels.reference[i], labels.response[j])) {
        continue;
      }
      const double sign = labels.sign(i) * labels.sign(j);
      if (!is_alike(compared(set, i, j, sign))) return false;
      ++paths;
    }
  }
  return paths > 0;
}

std::vector<std::size_t> pairs_of(const ExchangedLabels& exchange,
                                  const FrfSet& set,
                                  const std::vector<Reciprocal>& pairs) {
  std::vector<std::size_t> of;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (!is_alike(pairs[p]) && (is_of(exchange, set.frfs[pairs[p].frf]) ||
                                is_of(exchange, set.frfs[pairs[p].other]))) {
      of.push_back(p);
    }
  }
  return of;
}

// The channel that is written down where the run hit.
std::optional<std::size_t> sensor_at(const FrfSet& set, std::size_t run) {
  for (const Frf& frf : set.frfs) {
    if (frf.run == run && at_one(frf.response, frf.reference)) {
      return frf.channel;
    }
  }
  return {};
}

std::string sat_there(const TestBundle& bundle,
                      std::size_t channel,
                      std::size_t run) {
  return fmt::format(", or {} sat where run {} hit",
                     bundle.channels.at(channel).name,
                     run + 1);
}

std::string words(const TestBundle& bundle,
                  const FrfSet& set,
                  const ExchangedLabels& exchange) {
  if (!exchange.hits) {
    return fmt::format("{} and {} are swapped",
                       bundle.channels.at(exchange.one).name,
                       bundle.channels.at(exchange.other).name);
  }
  std::string text = fmt::format(
      "runs {} and {} hit another point than written down, each the "
      "other's",
      exchange.one + 1,
      exchange.other + 1);
  const auto one = sensor_at(set, exchange.one);
  const auto other = sensor_at(set, exchange.other);
  if (one && !other) text += sat_there(bundle, *one, exchange.other);
  if (other && !one) text += sat_there(bundle, *other, exchange.one);
  return text;
}

Finding finding_of(const TestBundle& bundle,
                   const FrfSet& set,
                   const std::vector<Reciprocal>& pairs,
                   const std::vector<ExchangedLabels>& alike) {
  Finding finding;
  const ExchangedLabels& first = alike.front();
  double apart = 0.0;
  std::set<std::size_t> runs;
  for (const std::size_t p : first.explained) {
    apart = std::max(apart, pairs[p].shape_difference);
    runs.insert(set.frfs[pairs[p].frf].run);
    runs.insert(set.frfs[pairs[p].other].run);
  }
  if (first.hits && alike.size() == 1) runs = {first.one, first.other};
  finding.where.runs.assign(runs.begin(), runs.end());
  if (!first.hits && alike.size() == 1) {
    finding.where.channel = bundle.channels.at(first.one).name;
  }
  finding.what = fmt::format(
      "{} measured both ways differ{} by up to {:.3g} %, whatever the factor, "
      "and agree once two labels are exchanged",
      first.explained.size() == 1
          ? std::string("a path")
          : fmt::format("{} paths", first.explained.size()),
      first.explained.size() == 1 ? "s" : "",
      100.0 * apart);
  finding.likely = words(bundle, set, first);
  for (std::size_t k = 1; k < alike.size(); ++k) {
    finding.likely += ", or " + words(bundle, set, alike[k]);
  }
  finding.remedy =
      first.hits
          ? "exchange `hammer` or `file` of these runs in test.json, or put "
            "the sensor where it was"
          : "exchange the two in test.json, or at the front end";
  return finding;
}

}  // namespace

bool is_of(const ExchangedLabels& exchange, const Frf& frf) {
  const std::size_t own = exchange.hits ? frf.run : frf.channel;
  return own == exchange.one || own == exchange.other;
}

std::vector<ExchangedLabels> exchanged_labels(
    const FrfSet& set, const std::vector<Reciprocal>& pairs) {
  std::set<std::size_t> channels;
  std::set<std::size_t> runs;
  for (const Frf& frf : set.frfs) {
    channels.insert(frf.channel);
    runs.insert(frf.run);
  }
  std::vector<ExchangedLabels> found;
  const auto try_all = [&](bool hits, const std::set<std::size_t>& labels) {
    for (const std::size_t one : labels) {
      for (const std::size_t other : labels) {
        if (other <= one) continue;
        ExchangedLabels exchange{hits, one, other, {}};
        exchange.explained = pairs_of(exchange, set, pairs);
        if (exchange.explained.empty()) continue;
        const std::optional<Labels> with = exchanged(set, exchange);
        if (with && holds(set, *with, exchange)) {
          found.push_back(std::move(exchange));
        }
      }
    }
  };
  try_all(false, channels);
  try_all(true, runs);
  std::ranges::stable_sort(found, std::greater{}, [](const auto& exchange) {
    return exchange.explained.size();
  });
  return found;
}

std::vector<Finding> exchange_findings(
    const TestBundle& bundle,
    const FrfSet& set,
    const std::vector<Reciprocal>& pairs,
    const std::vector<ExchangedLabels>& exchanges) {
  std::vector<Finding> findings;
  std::set<std::size_t> told;
  for (std::size_t k = 0; k < exchanges.size(); ++k) {
    const auto& explained = exchanges[k].explained;
    if (std::ranges::any_of(explained,
                            [&](std::size_t p) { return told.contains(p); })) {
      continue;
    }
    std::vector<ExchangedLabels> alike;
    for (std::size_t other = k; other < exchanges.size(); ++other) {
      if (exchanges[other].explained == explained) {
        alike.push_back(exchanges[other]);
      }
    }
    told.insert(explained.begin(), explained.end());
    findings.push_back(finding_of(bundle, set, pairs, alike));
  }
  return findings;
}

}  // namespace tapfit::signal
