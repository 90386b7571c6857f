#include "tests/planner/fleet/mixed_integer.hpp"

#include "core/require.hpp"
#include "planner/fleet/queue_clock.hpp"

#include <glpk.h>

#include <memory>
#include <utility>

namespace furrow::planner::fleet {
namespace {

constexpr double ever_s = 2'000.0;  ///< No plan of a small case takes as long.

/// Columns are numbered from 1, as GLPK does.
class Model {
 public:
  Model() : glpk_{glp_create_prob(), glp_delete_prob} {
    glp_term_out(GLP_OFF);
    glp_set_obj_dir(glpk_.get(), GLP_MIN);
  }

  int add(bool binary, double cost) {
    const int column = glp_add_cols(glpk_.get(), 1);
    if (binary) {
      glp_set_col_kind(glpk_.get(), column, GLP_BV);
    } else {
      glp_set_col_bnds(glpk_.get(), column, GLP_LO, 0.0, 0.0);
    }
    glp_set_obj_coef(glpk_.get(), column, cost);
    return column;
  }
  /// Sum of coefficient times column at least `low`; just that if `equal`.
  void at_least(const std::vector<std::pair<int, double>>& sum, double low, bool equal = false) {
    std::vector<int> columns{0};
    std::vector<double> values{0.0};
    for (const auto& [column, value] : sum) {
      columns.push_back(column);
      values.push_back(value);
    }
    const int row = glp_add_rows(glpk_.get(), 1);
    glp_set_row_bnds(glpk_.get(), row, equal ? GLP_FX : GLP_LO, low, low);
    glp_set_mat_row(glpk_.get(), row, static_cast<int>(sum.size()), columns.data(), values.data());
  }
  double least() {
    glp_iocp options;
    glp_init_iocp(&options);
    options.presolve = GLP_ON;
    options.msg_lev = GLP_MSG_OFF;
    require(glp_intopt(glpk_.get(), &options) == 0, "GLPK solves the model");
    return glp_mip_obj_val(glpk_.get());
  }

 private:
  std::unique_ptr<glp_prob, void (*)(glp_prob*)> glpk_;
};

using Sum = std::vector<std::pair<int, double>>;

/// One sortie that an aircraft may fly, the k-th.
struct Turn {
  std::uint32_t flier;
  bool first;
  std::vector<int> stretches;  ///< One column each: flown or not.
  int lands, served;           ///< Times, seconds.
};

class FleetModel {
 public:
  FleetModel(const FleetProblem& problem, const std::vector<double>& cuts_m, int most_sorties)
      : problem_{problem}, ends_m_{0.0}, makespan_{model_.add(false, 1.0)} {
    ends_m_.insert(ends_m_.end(), cuts_m.begin(), cuts_m.end());
    ends_m_.push_back(problem.path.length_m());
    for (std::size_t i = 0; i + 1 < ends_m_.size(); ++i) {
      for (std::size_t j = i + 1; j < ends_m_.size(); ++j) stretches_.emplace_back(i, j);
    }
    for (std::uint32_t u = 0; u < problem.fliers.size(); ++u) {
      for (int k = 0; k < most_sorties; ++k) add_turn(u, k == 0);
    }
  }

  double least_s() {
    cover();
    for (std::size_t t = 0; t < turns_.size(); ++t) fly(t);
    for (std::size_t a = 0; a < turns_.size(); ++a) {
      for (std::size_t b = a + 1; b < turns_.size(); ++b) queue(a, b);
    }
    return model_.least();
  }

 private:
  void add_turn(std::uint32_t flier, bool first) {
    Turn turn{flier, first, {}, model_.add(false, 0.0), model_.add(false, 0.0)};
    for (std::size_t s = 0; s < stretches_.size(); ++s)
      turn.stretches.push_back(model_.add(true, 0.0));
    turns_.push_back(std::move(turn));
  }
  double service_s(const Turn& t) const {
    return problem_.depots[0].service_s + problem_.fliers[t.flier].service_s;
  }
  Sum flown(const Turn& t, double each) const {
    Sum sum;
    for (const int s : t.stretches) sum.emplace_back(s, each);
    return sum;
  }
  void cover() {
    for (std::size_t cell = 0; cell + 1 < ends_m_.size(); ++cell) {
      Sum sum;
      for (const Turn& t : turns_) {
        for (std::size_t s = 0; s < stretches_.size(); ++s) {
          if (stretches_[s].first <= cell && cell < stretches_[s].second)
            sum.emplace_back(t.stretches[s], 1.0);
        }
      }
      model_.at_least(sum, 1.0, true);
    }
  }
  /// Begins after the service before it, flies one stretch or none, ends within the makespan.
  void fly(std::size_t number) {
    const Turn& t = turns_[number];
    const Flier& flier = problem_.fliers[t.flier];
    const FieldPoint from = t.first ? flier.start : problem_.depots[0].position;
    const double before_s = t.first ? 0.0 : service_s(t);
    model_.at_least(flown(t, -1.0), -1.0);
    Sum lands{{t.lands, 1.0}};
    for (std::size_t s = 0; s < stretches_.size(); ++s) {
      const Sortie sortie{ends_m_[stretches_[s].first], ends_m_[stretches_[s].second], t.flier, 0};
      lands.emplace_back(t.stretches[s], -before_s - flight_s(problem_, sortie, from));
      if (sortie.to_m - sortie.from_m > flier.tank_m + 1e-9)
        model_.at_least({{t.stretches[s], -1.0}}, 0.0);
    }
    if (!t.first) {
      const Turn& before = turns_[number - 1];
      lands.emplace_back(before.served, -1.0);
      Sum order = flown(before, 1.0);
      const Sum now = flown(t, -1.0);
      order.insert(order.end(), now.begin(), now.end());
      model_.at_least(order, 0.0);
    }
    model_.at_least(lands, 0.0);
    model_.at_least({{t.served, 1.0}, {t.lands, -1.0}}, 0.0);
    model_.at_least({{makespan_, 1.0}, {t.lands, -1.0}}, 0.0);
  }
  /// Services of two aircraft after turns a and b, where both fly on, one after the other.
  void queue(std::size_t a, std::size_t b) {
    if (turns_[a].flier == turns_[b].flier || !follows(a) || !follows(b)) return;
    const int a_first = model_.add(true, 0.0);
    // served b - served a >= service a - ever (1 - a_first) - ever (2 - flown on a - flown on b)
    const auto after = [&](std::size_t one, std::size_t other, double chosen, double left_out) {
      Sum sum{{turns_[other].served, 1.0}, {turns_[one].served, -1.0}, {a_first, chosen}};
      for (const std::size_t t : {a + 1, b + 1}) {
        const Sum flies_on = flown(turns_[t], -ever_s);
        sum.insert(sum.end(), flies_on.begin(), flies_on.end());
      }
      model_.at_least(sum, service_s(turns_[one]) - left_out - 2.0 * ever_s);
    };
    after(a, b, -ever_s, ever_s);
    after(b, a, ever_s, 0.0);
  }
  bool follows(std::size_t t) const {
    return t + 1 < turns_.size() && turns_[t + 1].flier == turns_[t].flier;
  }

  const FleetProblem& problem_;
  Model model_;
  std::vector<double> ends_m_;
  int makespan_;
  std::vector<std::pair<std::size_t, std::size_t>> stretches_;
  std::vector<Turn> turns_;
};

}  // namespace

double mixed_integer_makespan_s(const FleetProblem& problem, const std::vector<double>& cuts_m,
                                int most_sorties) {
  return FleetModel{problem, cuts_m, most_sorties}.least_s();
}

}  // namespace furrow::planner::fleet
