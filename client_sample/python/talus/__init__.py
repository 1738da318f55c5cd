from .content_hash import content_hash
from .decoder import DecodeError, decode
