#include "analysis/spectrum/fft.hpp"

#include <fftw3.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>

namespace swirl::analysis {

namespace detail {  // named, for it is in the type of a class's members

struct FftwFree {
    void operator()(void* memory) const { fftw_free(memory); }
};

}  // namespace detail

namespace {

using Complex = std::complex<double>;

/// FFTW's planner keeps its own global tables: making and destroying plans must not overlap. Executing may.
std::mutex& planner_mutex() {
    static std::mutex mutex;
    return mutex;
}

template <class T>
using Buffer = std::unique_ptr<T[], detail::FftwFree>;

/// FFTW's own allocation: always aligned for SIMD, so that every plan of one length is the same plan.
template <class T>
Buffer<T> allocate(std::size_t count) {
    Buffer<T> buffer(static_cast<T*>(fftw_malloc(sizeof(T) * count)));
    if (!buffer) throw std::bad_alloc();
    std::fill_n(buffer.get(), count, T{});
    return buffer;
}

std::size_t checked_length(std::size_t length) {
    if (length == 0 || length > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
        throw std::invalid_argument("FFT length = " + std::to_string(length) + ": must be in 1 … 2147483647");
    }
    return length;
}

// std::complex<double> has the layout of fftw_complex (FFTW manual, "Complex numbers").
fftw_complex* raw(Complex* values) {
    return reinterpret_cast<fftw_complex*>(values);
}

constexpr unsigned plan_flags = FFTW_ESTIMATE | FFTW_PRESERVE_INPUT;

fftw_plan make_plan(std::size_t n, double* in, Complex* out) {
    return fftw_plan_dft_r2c_1d(static_cast<int>(n), in, raw(out), plan_flags);
}
fftw_plan make_plan(std::size_t n, Complex* in, Complex* out) {
    return fftw_plan_dft_1d(static_cast<int>(n), raw(in), raw(out), FFTW_FORWARD, plan_flags);
}

std::size_t output_length(std::size_t n, double) {
    return n / 2 + 1;
}
std::size_t output_length(std::size_t n, Complex) {
    return n;
}

}  // namespace

template <class Sample>
struct Fft<Sample>::Plan {
    std::size_t inputs;
    std::size_t outputs;
    Buffer<Sample> input;
    Buffer<Complex> output;
    fftw_plan plan = nullptr;

    explicit Plan(std::size_t n)
        : inputs(checked_length(n)),
          outputs(output_length(n, Sample{})),
          input(allocate<Sample>(inputs)),
          output(allocate<Complex>(outputs)) {
        const std::lock_guard lock(planner_mutex());
        plan = make_plan(inputs, input.get(), output.get());
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;
    ~Plan() {
        const std::lock_guard lock(planner_mutex());
        fftw_destroy_plan(plan);
    }
};

template <class Sample>
Fft<Sample>::Fft(std::size_t length) : plan_(std::make_unique<Plan>(length)) {}
template <class Sample>
Fft<Sample>::~Fft() = default;
template <class Sample>
Fft<Sample>::Fft(Fft&&) noexcept = default;
template <class Sample>
Fft<Sample>& Fft<Sample>::operator=(Fft&&) noexcept = default;

template <class Sample>
std::size_t Fft<Sample>::length() const {
    return plan_->inputs;
}

template <class Sample>
std::span<Sample> Fft<Sample>::input() {
    return {plan_->input.get(), plan_->inputs};
}

template <class Sample>
std::span<const Complex> Fft<Sample>::transform() {
    fftw_execute(plan_->plan);
    return {plan_->output.get(), plan_->outputs};
}

template class Fft<double>;
template class Fft<Complex>;

}  // namespace swirl::analysis
