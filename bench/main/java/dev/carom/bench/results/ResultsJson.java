// SPDX-License-Identifier: Apache-2.0
package dev.carom.bench.results;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.StreamWriteFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Results as one JSON file: the metadata, then the rows, those that follow each other and differ
 * only in stat and value on one line. Reading gives the same rows back, in their order, to the last
 * bit.
 */
public final class ResultsJson {

  /** Rows that differ only in stat and value. */
  record Group(
      String scene,
      String method,
      String knob,
      String metric,
      String unit,
      long n,
      int fork,
      Map<String, Double> stats) {

    static Group of(Row r) {
      Map<String, Double> stats = new LinkedHashMap<>();
      stats.put(r.stat(), r.value());
      return new Group(
          r.scene(), r.method(), r.knob(), r.metric(), r.unit(), r.n(), r.fork(), stats);
    }

    /** Takes up a row if it belongs here. */
    boolean takes(Row r) {
      boolean fits = equals(of(r).withStats(stats)) && !stats.containsKey(r.stat());
      if (fits) {
        stats.put(r.stat(), r.value());
      }
      return fits;
    }

    private Group withStats(Map<String, Double> others) {
      return new Group(scene, method, knob, metric, unit, n, fork, others);
    }

    void addTo(List<Row> rows) {
      stats.forEach(
          (stat, value) ->
              rows.add(new Row(scene, method, knob, metric, stat, value, unit, n, fork)));
    }
  }

  /** The content of the file. */
  record Content(int version, Metadata metadata, List<Group> rows) {}

  private static final int VERSION = 1;

  private static final JsonMapper MAPPER =
      JsonMapper.builder()
          .enable(StreamWriteFeature.USE_FAST_DOUBLE_WRITER)
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(StreamReadFeature.INCLUDE_SOURCE_IN_LOCATION)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
          .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
          .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT)
          .build();

  private ResultsJson() {}

  /**
   * Writes results.
   *
   * @param file where; one that is there is replaced
   * @throws IOException if the file cannot be written
   */
  public static void write(Results results, Path file) throws IOException {
    StringWriter text = new StringWriter();
    try (JsonGenerator json = MAPPER.createGenerator(text)) {
      json.writeStartObject();
      json.writeNumberField("version", VERSION);
      json.writeRaw("\n");
      json.writePOJOField("metadata", results.metadata());
      json.writeArrayFieldStart("rows");
      for (Group group : groups(results.rows())) {
        json.writeRaw("\n");
        json.writePOJO(group);
      }
      json.writeEndArray();
      json.writeEndObject();
      json.writeRaw("\n");
    }
    WholeFile.write(file, text.toString());
  }

  private static List<Group> groups(List<Row> rows) {
    List<Group> groups = new ArrayList<>();
    for (Row row : rows) {
      if (groups.isEmpty() || !groups.get(groups.size() - 1).takes(row)) {
        groups.add(Group.of(row));
      }
    }
    return groups;
  }

  /**
   * Reads results back.
   *
   * @param file the file; where it is not there, the same with {@code .gz} at its end is unpacked
   * @return what was written
   * @throws IOException if it cannot be read, or holds no results: the message names the file, the
   *     place in it, and what is wrong
   */
  public static Results read(Path file) throws IOException {
    try (InputStream in = WholeFile.open(file)) {
      Content content = MAPPER.readValue(in, Content.class);
      if (content.version != VERSION) {
        throw new IOException(
            "%s: version is %d: expected %d".formatted(file, content.version, VERSION));
      }
      List<Row> rows = new ArrayList<>();
      for (int i = 0; i < content.rows.size(); i++) {
        check(file, i, content.rows.get(i));
        content.rows.get(i).addTo(rows);
      }
      return new Results(content.metadata, rows);
    } catch (JsonProcessingException e) {
      throw new IOException(file + place(e) + ": " + reason(e), e);
    }
  }

  private static void check(Path file, int i, Group group) throws IOException {
    if (group == null || group.stats.isEmpty() || group.stats.containsValue(null)) {
      throw new IOException(
          "%s: rows[%d] has no value: expected a number for each stat".formatted(file, i));
    }
  }

  private static String place(JsonProcessingException e) {
    JsonLocation at = e.getLocation();
    return at == null ? "" : ":" + at.getLineNr() + ":" + at.getColumnNr();
  }

  private static String reason(JsonProcessingException e) {
    String reason = e.getOriginalMessage().lines().findFirst().orElse("no JSON");
    return e instanceof JsonMappingException mapping ? path(mapping) + reason : reason;
  }

  /** Such as {@code rows[3].n: }. */
  private static String path(JsonMappingException e) {
    StringBuilder path = new StringBuilder();
    for (JsonMappingException.Reference step : e.getPath()) {
      if (step.getFieldName() == null) {
        path.append('[').append(step.getIndex()).append(']');
      } else {
        path.append(path.isEmpty() ? "" : ".").append(step.getFieldName());
      }
    }
    return path.isEmpty() ? "" : path + ": ";
  }
}
