// solve_ceres.cc: the only file that knows Ceres, and the only one in C++.
#include "solve.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <ceres/ceres.h>
#include <ceres/version.h>
#include <glog/logging.h>

namespace
{

// All residuals as one block; Ceres wants the Jacobian by rows.
class Residuals : public ceres::CostFunction
{
  public:
    explicit Residuals(const fit_problem *problem)
        : problem_(problem), columns_(problem->sample_count * problem->parameter_count),
          work_(2 * problem->sample_count)
    {
        set_num_residuals(static_cast<int>(problem->sample_count));
        mutable_parameter_block_sizes()->push_back(static_cast<int>(problem->parameter_count));
    }

    bool Evaluate(double const *const *parameters, double *residuals,
                  double **jacobians) const override
    {
        // A point where the model breaks is refused quietly: Ceres then takes a shorter step.
        if (!fit_residuals(problem_, parameters[0], residuals))
            return false;
        if (!jacobians || !jacobians[0])
            return true;
        if (!fit_jacobian(problem_, parameters[0], columns_.data(), work_.data()))
            return false;
        const size_t n = problem_->sample_count, m = problem_->parameter_count;
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < m; j++)
                jacobians[0][i * m + j] = columns_[j * n + i];
        return true;
    }

  private:
    const fit_problem *problem_;
    mutable std::vector<double> columns_, work_;
};

std::vector<int> parameters_on_bounds(const fit_problem *problem, const double *parameters)
{
    std::vector<int> found;
    for (int j = 0; j < static_cast<int>(problem->parameter_count); j++)
        if (parameters[j] <= problem->lower[j] || parameters[j] >= problem->upper[j])
            found.push_back(j);
    return found;
}

ceres::Solver::Summary solve_once(const fit_problem *problem, const fit_options *options,
                                  const std::vector<int> &held, double *parameters)
{
    const int count = static_cast<int>(problem->parameter_count);
    ceres::Problem ceres_problem;
    ceres_problem.AddResidualBlock(new Residuals(problem), nullptr, parameters);
    for (int j = 0; j < count; j++) {
        if (std::isfinite(problem->lower[j]))
            ceres_problem.SetParameterLowerBound(parameters, j, problem->lower[j]);
        if (std::isfinite(problem->upper[j]))
            ceres_problem.SetParameterUpperBound(parameters, j, problem->upper[j]);
    }
    if (!held.empty())
        ceres_problem.SetManifold(parameters, new ceres::SubsetManifold(count, held));

    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    solver.max_num_iterations = options->most_iterations;
    solver.parameter_tolerance = options->tolerance;
    // Sums of squares are flat at their minimum: these two would stop long before the parameters
    // have settled.
    solver.function_tolerance = 1e-30;
    solver.gradient_tolerance = 1e-30;

    ceres::Solver::Summary summary;
    ceres::Solve(solver, &ceres_problem, &summary);
    return summary;
}

} // namespace

const char *fit_ceres_version(void)
{
    return CERES_VERSION_STRING;
}

void fit_solve_ceres(const fit_problem *problem, const fit_options *options, fit_result *result)
{
    // What a non-finite residual would print goes to nobody.
    FLAGS_minloglevel = 3;

    const int count = static_cast<int>(problem->parameter_count);
    *result = fit_result();
    std::snprintf(result->solver, sizeof result->solver,
                  "Ceres %d.%d.%d Levenberg-Marquardt, dense QR", CERES_VERSION_MAJOR,
                  CERES_VERSION_MINOR, CERES_VERSION_REVISION);
    for (int j = 0; j < count; j++)
        result->parameters[j] = problem->start[j];

    // Ceres projects steps onto bounds and may then stop short along them: what has come to rest on
    // a bound is held there while the others go on.
    ceres::Solver::Summary summary;
    std::vector<int> held;
    for (int round = 0; round < 4; round++) {
        summary = solve_once(problem, options, held, result->parameters);
        result->iterations +=
            static_cast<int>(summary.num_successful_steps + summary.num_unsuccessful_steps);
        const std::vector<int> on_bound = parameters_on_bounds(problem, result->parameters);
        if (!summary.IsSolutionUsable() || on_bound == held ||
            on_bound.size() == problem->parameter_count)
            break;
        held = on_bound;
    }
    std::snprintf(result->status, sizeof result->status, "%s",
                  ceres::TerminationTypeToString(summary.termination_type));

    std::vector<double> residuals(problem->sample_count);
    const bool finite = fit_residuals(problem, result->parameters, residuals.data());
    result->objective = finite ? fit_sum_of_squares(problem, residuals.data())
                               : std::numeric_limits<double>::infinity();
    result->usable = finite && summary.IsSolutionUsable();
}
