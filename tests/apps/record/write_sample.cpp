// write_sample FILE: writes the sample record, for tests that look at it from another process.
#include <cstdio>
#include <exception>

#include "tests/apps/record/sample_record.hpp"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    try {
        swirl::tests::write_sample_record(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 4;
    }
    return 0;
}
