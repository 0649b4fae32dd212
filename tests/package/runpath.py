"""Where the programs that we build look for libraries: the paths that their
ELF headers name (System V ABI, "Dynamic Section"), read without tools.
"""

import struct

DT_NULL, DT_STRTAB, DT_RPATH, DT_RUNPATH = 0, 5, 15, 29
PT_LOAD, PT_DYNAMIC = 1, 2


def library_paths(path):
    """The entries of RPATH and RUNPATH of a 64-bit ELF file; None of another
    file."""
    data = path.read_bytes()
    if data[:4] != b"\x7fELF" or data[4] != 2:
        return None
    order = "<" if data[5] == 1 else ">"
    start, = struct.unpack_from(order + "Q", data, 32)
    size, count = struct.unpack_from(order + "HH", data, 54)
    headers = [struct.unpack_from(order + "IIQQQQ", data, start + i * size)
               for i in range(count)]

    def offset_of(address):
        for kind, _, offset, begin, _, length in headers:
            if kind == PT_LOAD and begin <= address < begin + length:
                return offset + address - begin
        raise ValueError(f"{path}: address {address:#x} is in no segment")

    entries = {}
    for kind, _, offset, _, _, length in headers:
        if kind != PT_DYNAMIC:
            continue
        for at in range(offset, offset + length, 16):
            tag, value = struct.unpack_from(order + "QQ", data, at)
            if tag == DT_NULL:
                break
            entries[tag] = value
    found = []
    for tag in (DT_RPATH, DT_RUNPATH):
        if tag in entries:
            begin = offset_of(entries[DT_STRTAB]) + entries[tag]
            text = data[begin:data.index(b"\0", begin)].decode()
            found += text.split(":")
    return found


def check(path):
    """How many entries a program has; each must be a folder of its own right:
    an empty or a relative one is the folder that somebody runs it in."""
    entries = library_paths(path) or []
    for entry in entries:
        assert entry.startswith(("/", "$ORIGIN")), (str(path), entries)
    return len(entries)
