"""Pictures of few colours as PNG files: a palette, and pixels that are not packed, since zlib packs differently from
one version to the next."""
import struct
import zlib


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def stored(data):
    """A zlib stream of blocks that are stored as they are."""
    blocks = [data[i:i + 65535] for i in range(0, len(data), 65535)]
    body = b"".join(struct.pack("<BHH", i == len(blocks) - 1, len(block), len(block) ^ 0xFFFF) + block
                    for i, block in enumerate(blocks))
    return b"\x78\x01" + body + struct.pack(">I", zlib.adler32(data))


def png(rows):
    """Rows of pixels, which are tuples (R, G, B) or (R, G, B, A) from 0 to 255, of at most 256 colours."""
    palette = sorted({tuple(pixel) for row in rows for pixel in row})
    numbers = {colour: i for i, colour in enumerate(palette)}
    bits = next(b for b in (1, 2, 4, 8) if len(palette) <= 1 << b)
    lines = bytearray()
    for row in rows:
        lines.append(0)
        for i in range(0, len(row), 8 // bits):
            packed = 0
            for k in range(8 // bits):
                packed = packed << bits | (numbers[tuple(row[i + k])] if i + k < len(row) else 0)
            lines.append(packed)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), bits, 3, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"PLTE", bytes(x for colour in palette for x in colour[:3]))]
    if len(palette[0]) == 4:
        chunks.append((b"tRNS", bytes(colour[3] for colour in palette)))
    chunks += [(b"IDAT", stored(bytes(lines))), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunk(kind, data) for kind, data in chunks)
