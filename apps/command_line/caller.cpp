#include "apps/command_line/caller.hpp"

#include <utility>

namespace swirl::apps {

namespace {

thread_local std::shared_ptr<Caller> current;

}  // namespace

void Caller::take_text(std::string_view text) {
    const std::lock_guard lock(mutex_);
    text_.emplace_back(text);
}

void Caller::take_message(const std::string& line) {
    const std::lock_guard lock(mutex_);
    messages_.push_back(line);
}

void Caller::begin_task(const std::string& name, double total) {
    const std::lock_guard lock(mutex_);
    task_ = Task{name, total, 0};
}

void Caller::at(double done) {
    const std::lock_guard lock(mutex_);
    if (task_) task_->done = done;
}

std::vector<std::string> Caller::take_out_text() {
    const std::lock_guard lock(mutex_);
    return std::exchange(text_, {});
}

std::vector<std::string> Caller::messages() const {
    const std::lock_guard lock(mutex_);
    return messages_;
}

std::optional<Caller::Task> Caller::task() const {
    const std::lock_guard lock(mutex_);
    return task_;
}

std::shared_ptr<Caller> caller_of_this_thread() {
    return current;
}

RunFor::RunFor(std::shared_ptr<Caller> caller) {
    current = std::move(caller);
}

RunFor::~RunFor() {
    current.reset();
}

}  // namespace swirl::apps
