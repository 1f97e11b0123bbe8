// cbrt as the native program has it. One flight in twenty asks for a cube root, whose last digit decides the last
// digits of all that follows, and C libraries differ in it: this is the number that the GNU C library gives up to its
// version 2.42. (A polynomial of degree 6 and one step of Halley's method; its coefficients and the order of operations
// are that library's, sysdeps/ieee754/dbl-64/s_cbrt.c by D. Husung and U. Drepper, 1997.)

#include <cmath>

extern "C" double cbrt(double x) {
    if (x == 0 || !std::isfinite(x)) return x + x;
    int exponent = 0;
    const double m = std::frexp(std::fabs(x), &exponent);
    const double coefficients[] = {0.784932344976639262, 1.83469277483613086, 2.44693122563534430, 2.11499494167371287,
                                   1.50819193781584896};
    double root = 0.145263899385486367;
    for (const double c : coefficients) root = c - root * m;
    root = 0.354895765043919860 + root * m;
    const double cube = root * root * root;
    const double per_third[] = {1 / 1.5874010519681994748, 1 / 1.2599210498948731648, 1, 1.2599210498948731648,
                                1.5874010519681994748};  // 2^(k/3), k = −2 … 2
    const double found = root * (cube + 2 * m) / (2 * cube + m) * per_third[2 + exponent % 3];
    return std::ldexp(x > 0 ? found : -found, exponent / 3);
}
