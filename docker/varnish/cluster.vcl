vcl 4.1;

# Varnish in front of HAProxy (docker/haproxy/haproxy.cfg), which sends each region of land to the server that has it warm:
#   varnishd -a :80 -f cluster.vcl -s malloc,8g
# Set the backend's address; Varnish's own and HAProxy's go into each talusd's `proxies`.

backend balancer {
    .host = "haproxy";
    .port = "80";
    .first_byte_timeout = 60s;  # talusd itself gives up after 20 s
    .max_connections = 1024;
}

include "./rules.vcl";
