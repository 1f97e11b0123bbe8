// F^k and its derivative in section coordinates, for who calls from another language. Angles of the image are taken
// within half a turn of those given, so that a cycle is a fixed point.
#include "apps/studies/scene_map/scene_map.hpp"
#include "map/model/scene.hpp"

#include <Eigen/Core>

#include <cmath>
#include <exception>

namespace {

using namespace swirl;

// AUTO's curve ends where contact lasts longer: guesses of Newton's method lead there, and to follow each takes a
// second.
constexpr double longest_contact = 50;

template <int D>
bool step(const studies::SceneMap<D>& map, int period, const double* from, double* image, double* derivative) {
    const auto start = Eigen::Map<const analysis::Vector<D>>(from);
    auto state = map.state_at(start);
    analysis::Matrix<D> product = analysis::Matrix<D>::Identity();
    for (int i = 0; i < period; ++i) {
        const auto next = map.linearise(state);
        if (!next.alive) return false;
        product = next.derivative * product;
        state = next.state;
    }
    analysis::Vector<D> end = map.coordinates(state);
    for (int i = 0; i < D; ++i)
        if (const double whole = map.angle_period(i); whole > 0)
            end[i] = start[i] + std::remainder(end[i] - start[i], whole);
    Eigen::Map<analysis::Vector<D>>(image, D) = end;
    Eigen::Map<analysis::Matrix<D>>(derivative, D, D) = product;
    return end.allFinite() && product.allFinite();
}

}  // namespace

/// 1 if there is an image. numbers: sides (0: a disk), alpha, beta, mu, e, kappa; z, image: psi, chi, vn, vt, S (a
/// disk's without chi); derivative by columns.
extern "C" int swirl_step(const double* numbers, int period, const double* z, double* image, double* derivative) {
    try {
        const Scene<double> scene{
            static_cast<int>(numbers[0]), numbers[1], numbers[2], numbers[3], numbers[4], Law::poisson, numbers[5]};
        return studies::with_scene_map(
            scene, [&](const auto& map) { return step(map, period, z, image, derivative); }, longest_contact);
    } catch (const std::exception&) {  // outside of the parameters' ranges
        return 0;
    }
}
