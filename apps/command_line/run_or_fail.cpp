#include "apps/command_line/run_or_fail.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/json/json_writer.hpp"
#include "apps/record/record_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

namespace swirl::apps {

int run_or_fail(const std::function<int()>& run, const std::function<void(const Failure&)>& tell) {
    const auto fail = [&tell](int code, std::string line, bool is_of_printing = false) {
        std::replace(line.begin(), line.end(), '\n', ' ');
        tell({code, line, is_of_printing});
        return code;
    };
    try {
        return run();
    } catch (const Interrupted&) {
        return exit_interrupted;
    } catch (const BadInput& error) {
        return fail(exit_bad_input, error.what());
    } catch (const std::invalid_argument& error) {
        return fail(exit_bad_input, error.what());
    } catch (const RecordError& error) {
        return fail(exit_io_failed, error.what());
    } catch (const JsonError& error) {
        return fail(exit_io_failed, error.what(), true);
    } catch (const std::system_error& error) {  // fmt, when a line can't be printed
        return fail(exit_io_failed, error.what(), true);
    } catch (const std::bad_alloc&) {
        return fail(exit_io_failed, "out of memory");
    } catch (const std::exception& error) {  // an error of a library that no command expects
        return fail(exit_numerical_ending, fmt::format("unexpected: {}", error.what()));
    }
}

}  // namespace swirl::apps
