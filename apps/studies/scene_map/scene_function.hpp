// The collision map of a scene on arrays of section points: rows of (psi, chi, vn, vt, S), of a disk (psi, vn, vt, S).
#pragma once

#include "map/model/scene.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::studies {

/// How the step of a row ended: swirl::Outcome, and one that a row of numbers may have besides.
inline constexpr std::uint8_t not_leaving =
    7;  ///< no state just after an impact (map/orbit/orbit.hpp, require_leaving)
std::vector<std::string_view> outcome_names();

class SceneFunction {
public:
    virtual ~SceneFunction() = default;

    virtual int dimension() const = 0;

    /// `steps` times F of each row of `z` into that row of `image`; NaN where the orbit ends before, or begins at no
    /// state just after an impact: `outcomes` says which. Rows go together, lane by lane, on `threads` threads
    /// (0: all); results are those of one row alone, bit for bit.
    ///   z, image   shape (n, dimension), row by row, of which `image` may be z
    ///   outcomes   of shape (n)
    ///   stop       asked now and then, by any thread: true to end, with rows that mean nothing
    virtual void map(std::span<const double> z, std::int64_t steps, int threads, std::span<double> image,
                     std::span<std::uint8_t> outcomes, const std::function<bool()>& stop) const = 0;

    /// F and DF, exact, through contact too.
    ///   derivative  shape (n, dimension, dimension): d image_i / d z_j at [row, i, j]
    virtual void derivative(std::span<const double> z, int threads, std::span<double> image,
                            std::span<double> derivative, std::span<std::uint8_t> outcomes,
                            const std::function<bool()>& stop) const = 0;
};

/// @throws std::invalid_argument for a scene out of range
std::unique_ptr<SceneFunction> function_of(const Scene<double>& scene);

}  // namespace swirl::studies
