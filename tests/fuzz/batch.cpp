#include "tests/fuzz/batch.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <new>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __SANITIZE_ADDRESS__
// As the limit of vybeg-reader: what is larger is not there, and no reason to stop. Its report of a
// death and not Qt's.
extern "C" const char* __asan_default_options() {
    return "allocator_may_return_null=1:max_allocation_size_mb=64:"
           "handle_segv=2:handle_sigbus=2:handle_sigfpe=2";
}
#endif

namespace vybeg::fuzz {
namespace {

constexpr int seconds_for_a_file = 2;
constexpr std::uint64_t files_of_a_process = 200;
constexpr std::size_t longest_fault = 200;

// What a process tells of its work, in memory that outlives it.
struct Progress {
    std::uint64_t next = 0;  // the file that is being tried, or is next
    std::array<std::uint64_t, 3> outcomes{};
    double slowest_s = 0;
    std::uint64_t faults = 0;
    std::array<std::array<char, longest_fault>, 10> fault{};  // the first ones
};

double processor_s() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void limit_memory([[maybe_unused]] std::size_t file_bytes) {
#ifndef __SANITIZE_ADDRESS__
    constexpr rlim_t allowance = rlim_t{64} << 20;
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    limit.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + file_bytes + allowance;
    setrlimit(RLIMIT_AS, &limit);
#endif
}

void limit_time() {
    rlimit limit{};
    getrlimit(RLIMIT_CPU, &limit);
    limit.rlim_cur = static_cast<rlim_t>(processor_s()) + seconds_for_a_file + 1;
    setrlimit(RLIMIT_CPU, &limit);
}

std::string place(std::uint64_t seed, const std::string& what) {
    return "seed " + std::to_string(seed) + " (" + what + "): ";
}

[[noreturn]] void work(Progress& progress, std::uint64_t end,
                       const std::function<Mutation(std::uint64_t)>& file_of,
                       const TryFile& try_file) {
    for (; progress.next < end; ++progress.next) {
        const Mutation mutation = file_of(progress.next);
        limit_memory(mutation.bytes.size());
        limit_time();
        const double start_s = processor_s();
        const Verdict verdict = try_file(mutation.bytes);
        progress.slowest_s = std::max(progress.slowest_s, processor_s() - start_s);
        ++progress.outcomes[static_cast<std::size_t>(verdict.outcome)];
        if (!verdict.fault.empty() && progress.faults < progress.fault.size()) {
            const std::string text = place(progress.next, mutation.what) + verdict.fault;
            text.copy(progress.fault[progress.faults++].data(), longest_fault - 1);
        }
    }
    std::_Exit(0);
}

// What a sanitizer says of a death; empty where it blames nothing of ours.
std::string blame(const std::string& log) {
    std::ifstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        const bool names_us =
            line.find("core/") != std::string::npos || line.find("vybeg::") != std::string::npos;
        const bool is_verdict = line.find("runtime error:") != std::string::npos ||
                                line.find("SUMMARY:") != std::string::npos;
        if (is_verdict && names_us) {
            return line;
        }
    }
    return {};
}

// A folder for the files of the processes: one that dies leaves its own behind.
class Workplace {
public:
    Workplace() : folder_(std::filesystem::temp_directory_path() / "vybeg-batch-XXXXXX") {
        if (!mkdtemp(folder_.data())) {
            std::perror(folder_.c_str());
            std::abort();
        }
    }
    Workplace(const Workplace&) = delete;
    Workplace& operator=(const Workplace&) = delete;
    ~Workplace() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    const std::string& folder() const { return folder_; }
    std::string log() const { return folder_ + "/log"; }

private:
    std::string folder_;
};

// Runs one process over the files from progress.next on and returns the status of waitpid().
int run(Progress& progress, std::uint64_t end, const Workplace& workplace,
        const std::function<Mutation(std::uint64_t)>& file_of, const TryFile& try_file) {
    const pid_t id = fork();
    if (id == 0) {
        setenv("TMPDIR", workplace.folder().c_str(), 1);
        const int file = open(workplace.log().c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(file, STDERR_FILENO);
        const rlimit no_core{0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
#ifndef __SANITIZE_ADDRESS__
        for (const int death : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGILL}) {
            std::signal(death, SIG_DFL);  // without Qt's debugger
        }
#endif
        work(progress, end, file_of, try_file);
    }
    int status = 0;
    while (waitpid(id, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

BatchCount try_batch(std::uint64_t first, std::uint64_t count,
                     const std::function<Mutation(std::uint64_t)>& file_of,
                     const TryFile& try_file) {
    void* const shared =
        mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        std::perror("shared memory");
        std::abort();
    }
    const Workplace workplace;
    BatchCount found;
    Progress& progress = *new (shared) Progress;
    progress.next = first;
    const std::uint64_t end = first + count;
    while (progress.next < end) {
        const std::uint64_t stop = std::min(progress.next + files_of_a_process, end);
        const int status = run(progress, stop, workplace, file_of, try_file);
        if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
            continue;
        }
        const std::uint64_t seed = progress.next++;
        const std::string ours = blame(workplace.log());
        if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
            ++found.endless;
        } else if (!ours.empty()) {
            found.faults.push_back(place(seed, file_of(seed).what) + ours);
        } else {
            ++found.deaths;
        }
    }
    for (std::uint64_t i = 0; i < progress.faults; ++i) {
        found.faults.emplace_back(progress.fault[i].data());
    }
    found.outcomes = progress.outcomes;
    found.slowest_s = progress.slowest_s;
    munmap(shared, sizeof(Progress));
    return found;
}

}  // namespace vybeg::fuzz
