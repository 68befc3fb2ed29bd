# The image of the hooks with -docker: the programs of the release, which are downloaded and compared with their sum. The image of
# smurf-lint alone is made of Containerfile.
ARG BASE=docker.io/library/python:3.13-slim-bookworm
FROM ${BASE}
COPY . /smurf
RUN pip install --no-cache-dir /smurf
