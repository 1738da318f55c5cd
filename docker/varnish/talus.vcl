vcl 4.1;

# Varnish in front of talusd's HTTP and WebSocket:
#   varnishd -a :80 -f /etc/varnish/talus.vcl -s malloc,8g
# Set the backend's address; Varnish's own goes into talusd's `proxies`. The test of it is tests/proxies/run.sh.

backend talus {
    .host = "127.0.0.1";
    .port = "4782";
    .first_byte_timeout = 60s;  # talusd itself gives up after 20 s
    .max_connections = 256;
}

include "./rules.vcl";
