#!/usr/bin/env bash
# Ceres 2.1.0 (Debian 12's) and 2.2.0 (Debian 13's), one residual under a Tukey loss whose scale is not a number, as a robust
# standard deviation of data that say nothing may be: the cost is NaN from the beginning. 2.1 reports CONVERGENCE, "Gradient
# tolerance reached", with a final cost that is NaN, and not a word on standard error. 2.2 reports FAILURE, and writes three lines
# on standard error although logging_type is SILENT. So a program that asks the summary whether the solver converged is told yes by
# one of them, and one whose standard error means something says more on the other: the scale is to be looked at before.
# As root, with mmdebstrap: two roots of these packages alone, in a temporary folder.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/cost.cpp" <<'END'
#include <ceres/ceres.h>
#include <ceres/version.h>
#include <cmath>
#include <cstdio>

struct Offset final : ceres::SizedCostFunction<1, 1> {
    bool Evaluate(double const* const* x, double* residual, double** slope) const override {
        residual[0] = x[0][0];
        if (slope && slope[0]) slope[0][0] = 1;
        return true;
    }
};

int main() {
    double x = 1;
    ceres::Problem problem;
    problem.AddResidualBlock(new Offset, new ceres::TukeyLoss(std::nan("")), &x);
    ceres::Solver::Options options;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    std::printf("Ceres %s: %s, final cost %s, x = %g\n", CERES_VERSION_STRING,
                ceres::TerminationTypeToString(summary.termination_type), std::isnan(summary.final_cost) ? "nan" : "a number", x);
}
END
for release in bookworm trixie; do
    case $release in
    bookworm) version=2.1.0+really2.1.0+dfsg-1 ;;
    trixie) version=2.2.0+dfsg-4.1+b2 ;;
    esac
    mmdebstrap --quiet --variant=apt --include="g++,libceres-dev=$version" "$release" "$folder/$release"
    cp "$folder/cost.cpp" "$folder/$release/tmp"
    chroot "$folder/$release" bash -c 'cd /tmp && g++ cost.cpp -I/usr/include/eigen3 -lceres -lglog -o cost && ./cost' \
        >"$folder/$release.out" 2>"$folder/$release.err"
    cat "$folder/$release.out"
    printf '%s: %d lines on standard error\n' "$release" "$(wc -l <"$folder/$release.err")"
done
grep -qx 'Ceres 2.1.0: CONVERGENCE, final cost nan, x = 1' "$folder/bookworm.out"
[[ ! -s $folder/bookworm.err ]]
grep -q '^Ceres 2.2.0: FAILURE' "$folder/trixie.out"
grep -q 'Accumulated cost = nan is not a finite number' "$folder/trixie.err"
