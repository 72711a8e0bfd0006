// SPDX-License-Identifier: BSD-3-Clause
#include "specplan/problems/OutputFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <ostream>
#include <system_error>
#include <utility>

#include "DescriptorBuffer.h"
#include "specplan/problems/InputError.h"

namespace specplan::problems
{
namespace fs = std::filesystem;

namespace
{
[[noreturn]] void refuse(const std::string& path, const std::string& reason)
{
    throw InputError(path, 0, "cannot be written: " + reason);
}

[[noreturn]] void refuse(const std::string& path, int error)
{
    refuse(path, std::generic_category().message(error));
}

/// What stands at the end of a name's links.
struct Target
{
    fs::path path;
    bool exists = false;
    struct stat status = {};

    /// Whether another file may take its place.
    [[nodiscard]] bool isReplaceable() const
    {
        return !exists || (S_ISREG(status.st_mode) && status.st_nlink == 1 && !isDescriptor());
    }

    /// Names such as /dev/stdout mean what is open there, which a new file would not be.
    [[nodiscard]] bool isDescriptor() const
    {
        const std::string text = path.string();
        return text.starts_with("/dev/") || text.starts_with("/proc/");
    }
};

/// \throws InputError if nothing can be written there.
Target targetOf(const std::string& name)
{
    constexpr int kMostLinks = 40;
    Target target{name};
    target.exists = ::stat(name.c_str(), &target.status) == 0;
    if (!target.exists && errno != ENOENT)
        refuse(name, errno);
    if (target.exists && S_ISDIR(target.status.st_mode))
        refuse(name, "it is a directory");
    if (target.isDescriptor())
        return target;
    std::error_code error;
    for (int links = 0; fs::is_symlink(fs::symlink_status(target.path, error)); ++links)
    {
        const fs::path next = fs::read_symlink(target.path, error);
        if (error || links == kMostLinks)
            refuse(name, ELOOP);
        target.path = next.is_absolute() ? next : target.path.parent_path() / next;
    }
    return target;
}

/// A file descriptor that is closed at the end.
class Descriptor
{
public:
    explicit Descriptor(int number) : number_(number)
    {
    }

    ~Descriptor()
    {
        if (number_ >= 0)
            ::close(number_);
    }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int number() const noexcept
    {
        return number_;
    }

    /// Some file systems tell only now that the disk is full. \return errno, 0 if all went well.
    int close()
    {
        return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno;
    }

private:
    int number_;
};

/// A new file beside another one, under a name that nobody has.
class Temporary
{
public:
    explicit Temporary(const fs::path& target)
    {
        constexpr int kTries = 100;
        for (int i = 0; descriptor_ < 0 && i < kTries; ++i)
        {
            path_ = target;
            path_ += concat('.', ::getpid(), '-', i, ".part");
            descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            if (descriptor_ < 0 && errno != EEXIST)
                break;
        }
        error_ = descriptor_ < 0 ? errno : 0;
    }

    ~Temporary()
    {
        if (descriptor_ >= 0 && !renamed_)
            ::unlink(path_.c_str());
    }

    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    /// The descriptor, for the caller to close; negative if there is no such file.
    [[nodiscard]] int descriptor() const noexcept
    {
        return descriptor_;
    }

    /// Why there is no such file (errno).
    [[nodiscard]] int error() const noexcept
    {
        return error_;
    }

    /// Gives it permissions and owner of another file. \return false if that is not allowed.
    [[nodiscard]] bool takeAfter(const struct stat& other) const
    {
        struct stat own = {};
        if (::fstat(descriptor_, &own) != 0)
            return false;
        const bool owned = own.st_uid == other.st_uid && own.st_gid == other.st_gid;
        return (owned || ::fchown(descriptor_, other.st_uid, other.st_gid) == 0) &&
               ::fchmod(descriptor_, other.st_mode & 07777U) == 0;
    }

    /// \return errno, 0 if all went well.
    int rename(const fs::path& target)
    {
        renamed_ = ::rename(path_.c_str(), target.c_str()) == 0;
        return renamed_ ? 0 : errno;
    }

private:
    fs::path path_;
    int descriptor_ = -1;
    int error_ = 0;
    bool renamed_ = false;
};

/// \throws InputError with the name if not all of it was written.
void writeAll(const std::string& name, Descriptor& descriptor, const std::function<void(std::ostream&)>& write)
{
    DescriptorBuffer buffer(descriptor.number());
    std::ostream out(&buffer);
    write(out);
    out.flush();
    if (buffer.error() != 0)
        refuse(name, buffer.error());
    if (!out)
        refuse(name, EIO);
    if (const int error = descriptor.close(); error != 0)
        refuse(name, error);
}

/// Writes to what is there.
void writeInPlace(const std::string& name, const std::function<void(std::ostream&)>& write)
{
    Descriptor descriptor(::open(name.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC | O_NOCTTY));
    if (descriptor.number() < 0)
        refuse(name, errno);
    writeAll(name, descriptor, write);
}

bool isWritableInPlace(const std::string& name, const Target& target)
{
    return target.exists && ::access(name.c_str(), W_OK) == 0;
}
}  // namespace

void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write)
{
    const Target target = targetOf(path);
    if (!target.isReplaceable())
    {
        writeInPlace(path, write);
        return;
    }
    Temporary temporary(target.path);
    Descriptor descriptor(temporary.descriptor());
    const bool asGood = descriptor.number() >= 0 && (!target.exists || temporary.takeAfter(target.status));
    if (!asGood && isWritableInPlace(path, target))
    {
        writeInPlace(path, write);
        return;
    }
    if (!asGood)
        refuse(path, descriptor.number() < 0 ? temporary.error() : EPERM);
    if (target.exists && ::access(path.c_str(), W_OK) != 0)  // as if it were opened
        refuse(path, errno);
    writeAll(path, descriptor, write);
    if (const int error = temporary.rename(target.path); error != 0)
        refuse(path, error);
}

void requireWritable(const std::string& path)
{
    const Target target = targetOf(path);
    if (target.exists)
    {
        if (::access(path.c_str(), W_OK) != 0)
            refuse(path, errno);
        return;
    }
    const Temporary temporary(target.path);
    const Descriptor descriptor(temporary.descriptor());
    if (descriptor.number() < 0)
        refuse(path, temporary.error());
}

bool isSameFile(const std::string& a, const std::string& b)
{
    struct stat statusA = {};
    struct stat statusB = {};
    const bool existsA = ::stat(a.c_str(), &statusA) == 0;
    const bool existsB = ::stat(b.c_str(), &statusB) == 0;
    if (existsA != existsB)
        return false;
    if (existsA)
        return !S_ISCHR(statusA.st_mode) && statusA.st_dev == statusB.st_dev && statusA.st_ino == statusB.st_ino;
    std::error_code error;
    // A name of nothing would stay relative.
    return fs::weakly_canonical(fs::absolute(targetOf(a).path), error) ==
           fs::weakly_canonical(fs::absolute(targetOf(b).path), error);
}
}  // namespace specplan::problems
