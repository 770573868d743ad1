#include "updating/screening.hpp"

#include "updating/effects/catalogue.hpp"
#include "updating/effects/point_effect.hpp"
#include "updating/parallel.hpp"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <map>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr int sizes_scanned = 13;

MatrixXd rows_of(const FrfModel& model,
                 const std::vector<int>& nodes,
                 int component) {
  MatrixXd rows(model.base().size(), static_cast<Index>(nodes.size()));
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    rows.col(static_cast<Index>(k)) =
        model.row(nodes[k], component).transpose();
  }
  return rows;
}

// The misfit and patterns with the tangent space of what readjusts taken out.
class Projector {
 public:
  explicit Projector(const MatrixXd& J) {
    if (J.cols() == 0) return;
    Eigen::ColPivHouseholderQR<MatrixXd> qr(J);
    qr.setThreshold(1e-8);
    Q_ = qr.householderQ() * MatrixXd::Identity(J.rows(), qr.rank());
  }
  [[nodiscard]] VectorXd operator()(const VectorXd& v) const {
    if (Q_.size() == 0) return v;
    return v - Q_ * (Q_.transpose() * v);
  }

 private:
  MatrixXd Q_;
};

// Sizes to try: those between which the effect goes from hardly visible to
// dominating, found from the place's own flexibility.
std::vector<double> sizes(const effects::ParameterSpec& spec) {
  std::vector<double> result;
  const double low = std::log(spec.lower);
  const double high = std::log(spec.upper);
  for (int k = 0; k < sizes_scanned; ++k) {
    result.push_back(std::exp(low + (high - low) * (k + 0.5) / sizes_scanned));
  }
  return result;
}

struct Scan {
  const PlacePatterns* patterns;
  const Target* target;
  const Projector* project;
  VectorXd misfit;  // projected

  [[nodiscard]] double error(std::size_t node,
                             const effects::Effect& effect,
                             double size) const {
    const MatrixXcd& P = patterns->pattern[node];
    const MatrixXcd& own = patterns->own[node];
    MatrixXcd change(P.rows(), P.cols());
    for (Index l = 0; l < P.rows(); ++l) {
      const std::complex<double> s = patterns->s(l);
      const std::complex<double> z = effect.law(s, {size}, 0);
      for (Index f = 0; f < P.cols(); ++f) {
        change(l, f) = -s * s * P(l, f) * z / (1.0 + own(l, f) * z);
      }
    }
    return (misfit + (*project)(stack(*target, change))).norm();
  }

  // Best size: a scan, then a golden section between its neighbours.
  [[nodiscard]] std::pair<double, double> best(
      std::size_t node,
      const effects::Effect& effect,
      const effects::ParameterSpec& spec) const {
    const std::vector<double> tried = sizes(spec);
    double least = 1e300;
    double at = tried.front();
    for (const double size : tried) {
      const double e = error(node, effect, size);
      if (e < least) {
        least = e;
        at = size;
      }
    }
    double ratio =
        std::exp(0.5 * std::log(spec.upper / spec.lower) / sizes_scanned);
    for (int k = 0; k < 4; ++k) {
      for (const double size : {at / ratio, at * ratio}) {
        const double e = error(node, effect, size);
        if (e < least) {
          least = e;
          at = size;
        }
      }
      ratio = std::sqrt(ratio);
    }
    return {at, least};
  }
};

}  // namespace

PlacePatterns place_patterns(const Fit& current,
                             const Target& target,
                             const std::vector<int>& nodes,
                             int component,
                             const Progress& progress) {
  const FrfModel& model = *current.model;
  PlacePatterns result;
  result.nodes = nodes;
  result.s = target.s;
  const MatrixXd candidates = rows_of(model, nodes, component);
  const Index lines = target.s.size();
  const Index frfs = target.H.cols();
  result.pattern.assign(nodes.size(), MatrixXcd(lines, frfs));
  result.own.assign(nodes.size(), MatrixXcd(lines, frfs));
  std::map<std::size_t, std::vector<Index>> runs;
  for (Index f = 0; f < frfs; ++f) {
    runs[target.run[static_cast<std::size_t>(f)]].push_back(f);
  }
  double done = 0.0;
  for (const auto& [run, members] : runs) {
    progress("diagnosis: patterns", done++ / static_cast<double>(runs.size()));
    const auto n = static_cast<Index>(members.size());
    MatrixXd points(model.base().size(), 2 * n);
    for (Index k = 0; k < n; ++k) {
      points.col(k) = model.response_row(members[static_cast<std::size_t>(k)]);
      points.col(n + k) =
          model.reference_row(members[static_cast<std::size_t>(k)]);
    }
    const std::vector<FrfModel::Columns> columns =
        model.columns(current.result.state, target.s, run, points, candidates);
    for (Index l = 0; l < lines; ++l) {
      const FrfModel::Columns& c = columns[static_cast<std::size_t>(l)];
      const MatrixXcd at = candidates.transpose() * c.X;  // nodes x 2n
      for (std::size_t b = 0; b < nodes.size(); ++b) {
        const auto row = static_cast<Index>(b);
        for (Index k = 0; k < n; ++k) {
          const Index f = members[static_cast<std::size_t>(k)];
          result.pattern[b](l, f) = at(row, k) * at(row, n + k);
          result.own[b](l, f) = c.own(row);
        }
      }
    }
  }
  return result;
}

std::vector<Screened> screen(const Fit& current,
                             const Fitter& fitter,
                             const Progress& progress) {
  const effects::Setting& setting = fitter.setting().setting;
  // The widest line: the most forgiving about shifts.
  const Target& target = fitter.setting().targets.front();
  const ModelResponse response =
      current.model->respond(current.result.state, target.s, true);
  MatrixXd J(2 * target.H.size(), static_cast<Index>(response.dH.size()));
  for (std::size_t k = 0; k < response.dH.size(); ++k) {
    J.col(static_cast<Index>(k)) = stack(target, response.dH[k]);
  }
  const Projector project(J);

  std::vector<Screened> result;
  std::vector<const effects::Effect*> kinds;
  for (const auto& effect : effects::catalogue()) {
    if (dynamic_cast<const effects::PointEffect*>(effect.get()) != nullptr) {
      kinds.push_back(effect.get());
    }
  }
  if (kinds.empty()) return result;
  std::vector<int> nodes;
  for (const Where& where : kinds.front()->places(setting)) {
    nodes.push_back(where.node);
  }
  const PlacePatterns patterns =
      place_patterns(current, target, nodes, setting.component, progress);
  const Scan scan{&patterns,
                  &target,
                  &project,
                  project(stack(target, response.H - target.H))};
  progress("diagnosis: screening", 0.5);
  result.resize(nodes.size() * kinds.size());
  for_each_parallel(nodes.size(), [&](std::size_t b) {
    Where where;
    where.node = nodes[b];
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const effects::ParameterSpec spec =
          kinds[k]->parameters(where, setting).front();
      const auto [size, error] = scan.best(b, *kinds[k], spec);
      result[b * kinds.size() + k] = {PlacedEffect{kinds[k], where, {size}},
                                      error};
    }
  });
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) {
    return a.error < b.error;
  });
  return result;
}

}  // namespace tapfit::updating
