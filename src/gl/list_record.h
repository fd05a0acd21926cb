// The stream of records that a display list is.
//
// A record is plain data: a header, the command's arguments, and the arrays and images it needs behind them.
// Records stand one after the other in blocks of memory, 8-byte aligned, and are never moved or changed once
// written, so a finished list may be played by several threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

namespace terrazzo::gl {

enum class Opcode : std::uint16_t;  // gl/generated/records.h

inline constexpr std::size_t kRecordAlignment = 8;

struct alignas(kRecordAlignment) RecordHeader {
    Opcode opcode;
    std::uint32_t size;  // bytes to the next record
};

// A record type is a standard-layout struct that begins with a RecordHeader.
template <typename Record>
const Record& record_cast(const RecordHeader& header) {
    return reinterpret_cast<const Record&>(header);
}

constexpr std::size_t padded(std::size_t size) {
    return (size + kRecordAlignment - 1) / kRecordAlignment * kRecordAlignment;
}

class DisplayList {
  public:
    // A record with `bytes_behind` uninitialised bytes after it. Throws std::bad_alloc and leaves the list as
    // it was.
    template <typename Record>
    Record& append(std::size_t bytes_behind = 0) {
        static_assert(std::is_standard_layout_v<Record> && std::is_trivially_copyable_v<Record>);
        const std::size_t size = sizeof(Record) + padded(bytes_behind);
        if (bytes_behind > kLargestRecord) throw std::bad_alloc();
        auto* record = new (allocate(size)) Record;
        record->header = {Record::kOpcode, static_cast<std::uint32_t>(size)};
        return *record;
    }

    template <typename Visitor>
    void for_each(Visitor visit) const {
        for (const Block& block : m_blocks) {
            for (std::size_t at = 0; at < block.used;) {
                const auto& header = *reinterpret_cast<const RecordHeader*>(block.bytes.get() + at);
                visit(header);
                at += header.size;
            }
        }
    }

    // What stands behind a record is no longer.
    static constexpr std::size_t kLargestRecord = UINT32_MAX - 4096;

  private:
    struct Block {
        std::unique_ptr<std::byte[]> bytes;
        std::size_t size;
        std::size_t used;
    };

    void* allocate(std::size_t size);

    std::vector<Block> m_blocks;
};

}  // namespace terrazzo::gl
