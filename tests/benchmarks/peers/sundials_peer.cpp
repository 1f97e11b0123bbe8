// SUNDIALS: CVODE (Adams, fixed-point iteration: nothing is stiff) with its root finding on the gaps of all vertices,
// as its manual has it; rising zeros only. At an impact the integrator is initialised anew. Over a floor with dry
// friction S is an unknown, too, and the means of friction are Swirl's (map/dry/uniform_pressure.hpp): what is compared
// there is the integration.
#include "container_frame.hpp"
#include "map/dry/uniform_pressure.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace swirl::peers {
namespace {

// X, X′, the angle of the vertex that has just struck; over a floor with dry friction S
constexpr int unknowns = 5, unknowns_over_dry_floor = 6;

void require(bool done, const char* what) {
    if (!done) throw std::runtime_error(std::string("SUNDIALS: ") + what);
}

class SundialsPeer final : public Peer {
public:
    SundialsPeer(const Scene<double>& scene, const Settings& settings) : scene_(scene), body_(make_body(scene)) {
        if (scene.has_dry_floor()) pressure_.emplace(scene.sides);
        require(SUNContext_Create(nullptr, &context_) == 0, "no context");
        y_ = N_VNew_Serial(pressure_ ? unknowns_over_dry_floor : unknowns, context_);
        solver_ = SUNNonlinSol_FixedPoint(y_, 0, context_);
        memory_ = CVodeCreate(CV_ADAMS, context_);
        require(y_ != nullptr && solver_ != nullptr && memory_ != nullptr, "no memory");
        N_VConst(0, y_);
        const int points = scene.is_disk() ? 1 : scene.sides;
        const std::vector<int> rising(static_cast<std::size_t>(points), 1);
        roots_.resize(rising.size());
        require(CVodeInit(memory_, rate, 0, y_) == 0 && CVodeSetUserData(memory_, this) == 0 &&
                    CVodeSStolerances(memory_, settings.tolerance, settings.tolerance) == 0 &&
                    CVodeSetNonlinearSolver(memory_, solver_) == 0 && CVodeSetMaxNumSteps(memory_, 1'000'000) == 0 &&
                    CVodeSetMaxStep(memory_, settings.step) == 0 && CVodeRootInit(memory_, points, gaps) == 0 &&
                    CVodeSetRootDirection(memory_, const_cast<int*>(rising.data())) == 0 &&
                    CVodeSetNoInactiveRootWarn(memory_) == 0,
                "a setting was refused");
    }
    SundialsPeer(const SundialsPeer&) = delete;
    SundialsPeer& operator=(const SundialsPeer&) = delete;
    ~SundialsPeer() override {
        CVodeFree(&memory_);
        SUNNonlinSolFree(solver_);
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }

    Impact next(const State& start) override {
        const ContainerState from = container_state(scene_, start);
        double* const y = N_VGetArrayPointer(y_);
        y[0] = from.centre.x, y[1] = from.centre.y, y[2] = from.velocity.x, y[3] = from.velocity.y, y[4] = from.angle;
        spin_ = from.spin;
        if (pressure_) y[5] = spin_;
        require(CVodeReInit(memory_, 0, y_) == 0, "could not begin");
        double t = 0;
        if (CVode(memory_, longest_flight, y_, &t, CV_NORMAL) != CV_ROOT_RETURN) return {};
        require(CVodeGetRootInfo(memory_, roots_.data()) == 0, "no root");
        int vertex = 0;
        while (roots_[static_cast<std::size_t>(vertex)] == 0) ++vertex;
        const Vec2<double> centre{y[0], y[1]};
        const State before = section_state(scene_, t, centre, {y[2], y[3]}, arm_of(scene_, centre, y[4], vertex),
                                           pressure_ ? y[5] : spin_);
        return {true, t, vertex, after_impact(scene_, before)};
    }

private:
    static int rate(double t, N_Vector y, N_Vector dy, void* self) {
        const auto& peer = *static_cast<SundialsPeer*>(self);
        const double* const v = N_VGetArrayPointer(y);
        double* const d = N_VGetArrayPointer(dy);
        d[0] = v[2];
        d[1] = v[3];
        d[2] = peer.scene_.beta * std::cos(t);
        d[3] = peer.scene_.beta * std::sin(t);
        d[4] = peer.spin_;
        if (!peer.pressure_) return 0;
        Vec2<double> slip{v[2], v[3]};
        if (peer.scene_.floor == Floor::table) slip = slip + peer.scene_.beta * Vec2<double>{-std::sin(t), std::cos(t)};
        const Vec2<double> arm = peer.scene_.alpha * Vec2<double>{std::cos(v[4]), std::sin(v[4])};
        const MeanSlip<double> mean = peer.pressure_->mean_slip(peer.body_, slip, v[5], arm);
        const double a = peer.scene_.floor_deceleration();
        d[2] -= a * mean.direction.x;
        d[3] -= a * mean.direction.y;
        d[4] = v[5];
        d[5] = -a * mean.moment / peer.body_.inertia;
        return 0;
    }
    static int gaps(double, N_Vector y, double* gap, void* self) {
        const auto& scene = static_cast<SundialsPeer*>(self)->scene_;
        const double* const v = N_VGetArrayPointer(y);
        const Vec2<double> centre{v[0], v[1]};
        if (scene.is_disk()) {
            gap[0] = dot(centre, centre) - (1 - scene.alpha) * (1 - scene.alpha);
            return 0;
        }
        for (int k = 0; k < scene.sides; ++k) {
            const Vec2<double> x = centre + arm_of(scene, centre, v[4], k);
            gap[k] = dot(x, x) - 1;
        }
        return 0;
    }

    Scene<double> scene_;
    Body<double> body_;
    std::optional<UniformPressure> pressure_;
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
    SUNNonlinearSolver solver_ = nullptr;
    void* memory_ = nullptr;
    double spin_ = 0;
    std::vector<int> roots_;
};

}  // namespace

std::unique_ptr<Peer> make_sundials_peer(const Scene<double>& scene, const Settings& settings) {
    return std::make_unique<SundialsPeer>(scene, settings);
}

}  // namespace swirl::peers
