#include "analysis/classification/surrogates.hpp"

#include "analysis/classification/series_exponent.hpp"
#include "analysis/random_draws.hpp"
#include "analysis/special_values.hpp"
#include "analysis/spectrum/fft.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

namespace swirl::analysis {

namespace {

constexpr std::size_t most_for_surrogates = 1000;

/// Uniform numbers of one surrogate, the same whatever came before.
class Draws {
public:
    Draws(std::uint64_t kind, std::uint64_t draw) : kind_(kind), draw_(draw) {}
    double uniform() {  ///< in (0, 1]
        return uniform_draws({draw_, number_++, 0, 0}, {kind_, 0x737572726f67})[0];
    }
    std::size_t below(std::size_t n) {
        return std::min(n - 1, static_cast<std::size_t>((1 - uniform()) * static_cast<double>(n)));
    }
    template <class T>
    void shuffle(std::vector<T>& values) {
        for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[below(i)]);
    }

private:
    std::uint64_t kind_, draw_, number_ = 0;
};

std::vector<std::size_t> ranks_of(std::span<const double> x) {
    std::vector<std::size_t> order(x.size()), ranks(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
    for (std::size_t r = 0; r < order.size(); ++r) ranks[order[r]] = r;
    return ranks;
}

/// Runs of `order` values by number, in the order of their first places, and the number of each place's run.
struct Contexts {
    std::vector<std::size_t> at;     // of the run that ends at place i + order − 1
    std::vector<std::size_t> first;  // place of a run's first end
};

Contexts contexts_of(std::span<const double> x, std::size_t order) {
    Contexts contexts;
    std::map<std::vector<double>, std::size_t> numbers;
    for (std::size_t i = 0; i + order <= x.size(); ++i) {
        const auto begin = x.begin() + static_cast<std::ptrdiff_t>(i);
        const auto [found, is_new] =
            numbers.try_emplace({begin, begin + static_cast<std::ptrdiff_t>(order)}, contexts.first.size());
        if (is_new) contexts.first.push_back(i + order - 1);
        contexts.at.push_back(found->second);
    }
    return contexts;
}

/// For each context one of its transitions, such that following them leads from everywhere to the last context: random
/// walks without their loops (Wilson 1996).
std::vector<std::size_t> random_tree(const std::vector<std::vector<std::size_t>>& next, std::size_t root,
                                     Draws& draws) {
    std::vector<std::size_t> chosen(next.size(), 0);
    std::vector<bool> in_tree(next.size(), false);
    in_tree[root] = true;
    for (std::size_t start = 0; start < next.size(); ++start) {
        for (std::size_t c = start; !in_tree[c]; c = next[c][chosen[c]]) chosen[c] = draws.below(next[c].size());
        for (std::size_t c = start; !in_tree[c]; c = next[c][chosen[c]]) in_tree[c] = true;
    }
    return chosen;
}

/// Root mean square error of predicting x one delay ahead by the mean of the four nearest delay vectors of dimension 3.
double prediction_error(std::span<const double> x, std::size_t delay) {
    constexpr std::size_t neighbours = 4;
    const std::size_t ahead = 3 * delay;
    const std::size_t points = x.size() - ahead;
    NeighbourSearch search({x, 3, delay}, points, NeighbourSearch::Equal::counts);
    double squares = 0;
    for (std::size_t i = 0; i < points; ++i) {
        double prediction = 0;
        const auto near = search.nearest(i, neighbours, ahead);
        for (const auto& [distance, j] : near) prediction += x[j + ahead] / static_cast<double>(near.size());
        squares += (x[i + ahead] - prediction) * (x[i + ahead] - prediction);
    }
    return std::sqrt(squares / static_cast<double>(points));
}

/// The part, at least nine tenths, whose ends fit each other best, in value and slope: a Fourier transform takes what
/// does not for a jump.
std::span<const double> with_fitting_ends(std::span<const double> x) {
    const std::size_t slack = x.size() / 20;
    double least = infinity;
    std::size_t begin = 0, end = x.size();
    for (std::size_t b = 0; b < slack; ++b)
        for (std::size_t e = x.size() - slack; e < x.size(); ++e) {
            const double value = x[e] - x[b], slope = (x[e] - x[e - 1]) - (x[b + 1] - x[b]);
            const double misfit = value * value + slope * slope;
            if (misfit < least) least = misfit, begin = b, end = e;
        }
    return x.subspan(begin, end - begin);
}

}  // namespace

std::vector<double> fourier_surrogate(std::span<const double> x, std::uint64_t draw) {
    constexpr int most_rounds = 100;
    const std::size_t n = x.size();
    Draws draws(1, draw);
    std::vector<double> sorted(x.begin(), x.end()), result = sorted;
    draws.shuffle(result);
    std::sort(sorted.begin(), sorted.end());
    RealFft forward(n);
    std::copy(x.begin(), x.end(), forward.input().begin());
    std::vector<double> amplitudes;
    for (const auto& value : forward.transform()) amplitudes.push_back(std::abs(value));
    ComplexFft back(n);
    std::vector<double> shape(n);
    std::vector<std::size_t> before;
    for (int round = 0; round < most_rounds; ++round) {
        std::copy(result.begin(), result.end(), forward.input().begin());
        const auto image = forward.transform();
        for (std::size_t k = 0; k < image.size(); ++k) {
            const double size = std::abs(image[k]);
            const auto turned = size > 0 ? image[k] * (amplitudes[k] / size) : std::complex<double>(amplitudes[k]);
            back.input()[k] = std::conj(turned);  // forward again, of the conjugate: the inverse of a real series
            if (k > 0 && n - k > k) back.input()[n - k] = turned;
        }
        const auto waves = back.transform();
        for (std::size_t i = 0; i < n; ++i) shape[i] = waves[i].real();
        const auto ranks = ranks_of(shape);
        if (ranks == before) break;
        for (std::size_t i = 0; i < n; ++i) result[i] = sorted[ranks[i]];
        before = ranks;
    }
    return result;
}

std::vector<double> markov_surrogate(std::span<const double> x, std::size_t order, std::uint64_t draw) {
    Draws draws(1 + order, draw);
    const Contexts contexts = contexts_of(x, order);
    std::vector<std::vector<std::size_t>> next(contexts.first.size());
    for (std::size_t i = 0; i + 1 < contexts.at.size(); ++i) next[contexts.at[i]].push_back(contexts.at[i + 1]);
    const std::size_t root = contexts.at.back();
    const auto last = random_tree(next, root, draws);
    for (std::size_t c = 0; c < next.size(); ++c) {
        if (next[c].empty()) continue;
        if (c != root) std::swap(next[c][last[c]], next[c].back());
        const std::size_t kept = c == root ? 0 : next[c].back();
        if (c != root) next[c].pop_back();
        draws.shuffle(next[c]);
        if (c != root) next[c].push_back(kept);
    }
    std::vector<double> result(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(order));
    std::vector<std::size_t> used(next.size(), 0);
    for (std::size_t c = contexts.at.front(); result.size() < x.size();) {
        c = next[c][used[c]++];
        result.push_back(x[contexts.first[c]]);
    }
    return result;
}

std::vector<double> dwell_surrogate(std::span<const double> x, std::uint64_t draw) {
    Draws draws(9, draw);
    std::vector<double> values;
    std::map<double, std::vector<std::size_t>> stays;
    for (std::size_t i = 0, begin = 0; i < x.size(); ++i)
        if (i + 1 == x.size() || x[i + 1] != x[i]) {
            values.push_back(x[i]);
            stays[x[i]].push_back(i + 1 - begin);
            begin = i + 1;
        }
    for (auto& [value, lengths] : stays) draws.shuffle(lengths);
    std::vector<double> result;
    for (const double value : values) {
        result.insert(result.end(), stays[value].back(), value);
        stays[value].pop_back();
    }
    return result;
}

SurrogateTest test_surrogates(std::span<const double> series) {
    constexpr std::size_t often = 10;
    auto x = series.size() > most_for_surrogates ? series.last(most_for_surrogates) : series;
    const std::size_t delay = std::min(decorrelation(x), x.size() / 16);
    x = with_fitting_ends(x);
    using KindOfNoise = std::pair<const char*, std::function<std::vector<double>(std::uint64_t)>>;
    std::vector<KindOfNoise> kinds{{"linear noise", [&](std::uint64_t draw) { return fourier_surrogate(x, draw); }}};
    for (const std::size_t order : {1, 2})
        if (contexts_of(x, order).first.size() * often <= x.size())
            kinds.emplace_back("a Markov chain", [=](std::uint64_t draw) { return markov_surrogate(x, order, draw); });
    std::size_t changes = 0;
    for (std::size_t i = 1; i < x.size(); ++i) changes += x[i] != x[i - 1] ? 1 : 0;
    if (kinds.size() > 1 && 2 * changes <= x.size())
        kinds.emplace_back("a telegraph", [&](std::uint64_t draw) { return dwell_surrogate(x, draw); });
    SurrogateTest test;
    test.error = prediction_error(x, delay);
    test.smallest_of_surrogates = infinity;
    for (const auto& [kind, surrogate] : kinds)
        for (int i = 0; i < test.surrogates; ++i) {
            const double error = prediction_error(surrogate(static_cast<std::uint64_t>(i)), delay);
            if (error < test.smallest_of_surrogates) test.smallest_of_surrogates = error, test.kind = kind;
        }
    return test;
}

}  // namespace swirl::analysis
