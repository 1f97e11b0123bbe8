"""Certificates of swirl certify, edited and given a checksum that fits."""


def crc64_xz(data):
    crc = ~0 & (2**64 - 1)
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0xC96C5795D7870F42 if crc & 1 else 0)  # 42f0e1eba9ea3693, reflected
    return crc ^ (2**64 - 1)


def with_new_checksum(text):
    body = text[:text.rindex(",\n  \"checksum\"")]
    return f"{body},\n  \"checksum\": \"crc-64/xz {crc64_xz(body.encode()):016x}\"\n}}\n"
