#pragma once

#include <string>
#include <vector>

namespace meniscus::povray {

/// What POV-Ray prints on standard error, understood.
class Console {
public:
    explicit Console(const std::string& text);

    /// Each on one line: "File 'a.pov' line 3: Parse Warning: ...".
    const std::vector<std::string>& warnings() const { return warnings_; }
    /// Its words from the first error on; all of them if none is called so.
    const std::string& error() const { return error_; }
    /// Of the trace stage, wall clock and summed over threads; 0 if it did not come so far.
    double seconds() const { return seconds_; }
    double cpu_seconds() const { return cpu_seconds_; }

private:
    std::vector<std::string> warnings_;
    std::string error_;
    double seconds_ = 0.0, cpu_seconds_ = 0.0;
};

}  // namespace meniscus::povray
