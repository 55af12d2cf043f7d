# SPDX-License-Identifier: BSD-3-Clause
"""A client of the WebSocket protocol (RFC 6455), as far as a browser's remote control needs it: texts alone."""

import base64
import os
import socket
import struct
import urllib.parse


class WebSocket:
    """A connection to an address that begins with ws://."""

    def __init__(self, address, timeout):
        url = urllib.parse.urlsplit(address)
        self.socket = socket.create_connection((url.hostname, url.port), timeout=timeout)
        self.received = b""
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET {url.path} HTTP/1.1\r\nHost: {url.hostname}:{url.port}\r\nUpgrade: websocket\r\n"
                             f"Connection: Upgrade\r\nSec-WebSocket-Key: {key}\r\n"
                             "Sec-WebSocket-Version: 13\r\n\r\n").encode())
        while b"\r\n\r\n" not in self.received:
            self.receive_more()
        head, self.received = self.received.split(b"\r\n\r\n", 1)
        if b" 101 " not in head.split(b"\r\n", 1)[0]:
            raise ConnectionError(head.decode())

    def close(self):
        self.socket.close()

    def receive_more(self):
        more = self.socket.recv(1 << 20)
        if not more:
            raise ConnectionError("the browser closed the connection")
        self.received += more

    def take(self, count):
        while len(self.received) < count:
            self.receive_more()
        taken, self.received = self.received[:count], self.received[count:]
        return taken

    def send_frame(self, kind, payload):
        count = len(payload)
        head = bytes([0x80 | kind])
        if count < 126:
            head += bytes([0x80 | count])
        elif count < 65536:
            head += bytes([0x80 | 126]) + struct.pack(">H", count)
        else:
            head += bytes([0x80 | 127]) + struct.pack(">Q", count)
        mask = os.urandom(4)
        self.socket.sendall(head + mask + bytes(byte ^ mask[i % 4] for i, byte in enumerate(payload)))

    def send(self, text):
        self.send_frame(1, text.encode())

    def receive(self):
        """The next text; waits until there is one."""
        message = b""
        while True:
            first, second = self.take(2)
            count = second & 127
            if count >= 126:
                count = int.from_bytes(self.take(2 if count == 126 else 8), "big")
            payload = self.take(count)
            kind = first & 15
            if kind == 9:  # a ping
                self.send_frame(10, payload)
            elif kind == 8:
                raise ConnectionError("the browser closed the connection")
            elif kind in (0, 1, 2):
                message += payload
                if first & 0x80:
                    return message.decode()
