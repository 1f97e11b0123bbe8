// Who runs a command: this program, whose standard streams and signals are the command's, or another one that it is a
// part of (apps/python), which takes the document, the messages and the progress, and says when to stop.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace swirl::apps {

/// One run of a command for another program. Its members are asked and told by several threads.
class Caller {
public:
    /// How far the task at hand is.
    struct Task {
        std::string name;
        double total = 0, done = 0;
    };

    void take_text(std::string_view text);
    void take_message(const std::string& line);
    void begin_task(const std::string& name, double total);
    void at(double done);

    /// The run is to end soon, with what is finished.
    void stop() { stopped_ = true; }
    bool is_stopped() const { return stopped_; }
    /// Is what is finished being written, however long that takes?
    bool is_finishing() const { return finishing_; }
    void set_finishing(bool finishing) { finishing_ = finishing; }

    /// What the command has printed, piece by piece as it came: handed over, for it may be long.
    std::vector<std::string> take_out_text();
    std::vector<std::string> messages() const;
    std::optional<Task> task() const;

private:
    mutable std::mutex mutex_;
    std::vector<std::string> text_, messages_;
    std::optional<Task> task_;
    std::atomic<bool> stopped_ = false, finishing_ = false;
};

/// For whom this thread runs a command; null: the command is the program.
std::shared_ptr<Caller> caller_of_this_thread();

/// While it lives this thread runs a command for `caller`.
class RunFor {
public:
    explicit RunFor(std::shared_ptr<Caller> caller);
    ~RunFor();
    RunFor(const RunFor&) = delete;
    RunFor& operator=(const RunFor&) = delete;
};

}  // namespace swirl::apps
