// Is a series predicted better than noise that shares its linear correlations, its distribution, its transitions?
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace swirl::analysis {

/// The series' values with its power spectrum and random phases: amplitudes and values are put right in turn, at most
/// 100 times, until the order of the values stays (Schreiber & Schmitz, Phys. Rev. Lett. 77 (1996) 635). Of Gaussian
/// noise behind any static function. Philox, keyed by `draw`.
std::vector<double> fourier_surrogate(std::span<const double> x, std::uint64_t draw);

/// A series of the same first `order` values with each run of `order` + 1 values as often as in x: its transitions in
/// a random order that uses up all of them (Altschul & Erickson, Mol. Biol. Evol. 2 (1985) 526). Of a Markov chain.
std::vector<double> markov_surrogate(std::span<const double> x, std::size_t order, std::uint64_t draw);

/// The values of x in their sequence, but each value's times of stay among themselves in a random order. Of a
/// telegraph whose stays are independent, however long they last.
std::vector<double> dwell_surrogate(std::span<const double> x, std::uint64_t draw);

/// Nonlinear prediction error of the series (last 1000 samples at most) and the smallest of its surrogates'. Fourier
/// surrogates; of a series whose values come ten times each on the mean also surrogates of Markov chains, of the
/// first and, if pairs of values come ten times, of the second order; and of stays, if values stay for two samples or
/// more on the mean. Equal series, equal numbers. O(surrogates n^(5/3)).
struct SurrogateTest {
    double error = 0;
    double smallest_of_surrogates = 0;
    std::string kind;     ///< of the surrogates of which one is predicted best: "linear noise", "a Markov chain", …
    int surrogates = 39;  ///< of each kind

    /// A limit that noise stays above, by a twentieth below the surrogates': the best of 39 errs more than one draw in
    /// forty of its own kind, but not by much.
    double limit() const { return 0.95 * smallest_of_surrogates; }
};
SurrogateTest test_surrogates(std::span<const double> series);

}  // namespace swirl::analysis
