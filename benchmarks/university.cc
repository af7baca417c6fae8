#include "benchmarks/university.h"

#include <random>
#include <vector>

namespace lares::bench {
namespace {

constexpr const char* kOntology = R"(
@prefix : <http://example.org/university#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .

:Work a owl:Class .
:Course a owl:Class ; rdfs:subClassOf :Work .
:GraduateCourse a owl:Class ; rdfs:subClassOf :Course .
:Publication a owl:Class .
:Organization a owl:Class .
:University a owl:Class ; rdfs:subClassOf :Organization .
:Department a owl:Class ; rdfs:subClassOf :Organization .
:ResearchGroup a owl:Class ; rdfs:subClassOf :Organization .

:Person a owl:Class .
:Employee a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( :Person
  [ a owl:Restriction ; owl:onProperty :worksFor ; owl:someValuesFrom :Organization ] ) ] .
:Faculty a owl:Class ; rdfs:subClassOf :Employee .
:Lecturer a owl:Class ; rdfs:subClassOf :Faculty .
:Professor a owl:Class ; rdfs:subClassOf :Faculty .
:FullProfessor a owl:Class ; rdfs:subClassOf :Professor .
:AssociateProfessor a owl:Class ; rdfs:subClassOf :Professor .
:AssistantProfessor a owl:Class ; rdfs:subClassOf :Professor .
:Chair a owl:Class ; rdfs:subClassOf :Professor ; owl:equivalentClass [ owl:intersectionOf ( :Person
  [ a owl:Restriction ; owl:onProperty :headOf ; owl:someValuesFrom :Department ] ) ] .
:Student a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( :Person
  [ a owl:Restriction ; owl:onProperty :takesCourse ; owl:someValuesFrom :Course ] ) ] .
:UndergraduateStudent a owl:Class ; rdfs:subClassOf :Student .
:GraduateStudent a owl:Class ; rdfs:subClassOf :Person .
:TeachingAssistant a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( :Person
  [ a owl:Restriction ; owl:onProperty :teachingAssistantOf ; owl:someValuesFrom :Course ] ) ] .
:ResearchAssistant a owl:Class ; rdfs:subClassOf :Person .

:subOrganizationOf a owl:ObjectProperty , owl:TransitiveProperty ;
  rdfs:domain :Organization ; rdfs:range :Organization .
:memberOf a owl:ObjectProperty ; owl:inverseOf :member .
:member a owl:ObjectProperty ; rdfs:domain :Organization ; rdfs:range :Person .
:worksFor a owl:ObjectProperty ; rdfs:subPropertyOf :memberOf .
:headOf a owl:ObjectProperty ; rdfs:subPropertyOf :worksFor .
:degreeFrom a owl:ObjectProperty ; owl:inverseOf :hasAlumnus ;
  rdfs:domain :Person ; rdfs:range :University .
:hasAlumnus a owl:ObjectProperty .
:undergraduateDegreeFrom a owl:ObjectProperty ; rdfs:subPropertyOf :degreeFrom .
:mastersDegreeFrom a owl:ObjectProperty ; rdfs:subPropertyOf :degreeFrom .
:doctoralDegreeFrom a owl:ObjectProperty ; rdfs:subPropertyOf :degreeFrom .
:takesCourse a owl:ObjectProperty .
:teacherOf a owl:ObjectProperty ; rdfs:domain :Faculty ; rdfs:range :Course .
:teachingAssistantOf a owl:ObjectProperty ; rdfs:domain :TeachingAssistant ; rdfs:range :Course .
:advisor a owl:ObjectProperty ; rdfs:domain :Person ; rdfs:range :Professor .
:publicationAuthor a owl:ObjectProperty ; rdfs:domain :Publication ; rdfs:range :Person .
:name a owl:DatatypeProperty .
:emailAddress a owl:DatatypeProperty ; rdfs:domain :Person .
:telephone a owl:DatatypeProperty ; rdfs:domain :Person .
:researchInterest a owl:DatatypeProperty .
)";

constexpr const char* kType = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type";
constexpr const char* kWords = "http://example.org/university#";
constexpr int kUniversities = 1000;  // that a degree may be from

class Writer {
 public:
  explicit Writer(int number)
      : number_(number), random_(static_cast<unsigned>(number) + 1), home_(University(number)) {}

  std::string Write() {
    Is(home_, "University");
    Says(home_, "name", "University" + std::to_string(number_));
    const int departments = Draw(15, 25);
    for (int i = 0; i < departments; ++i) Department(i);
    return std::move(text_);
  }

 private:
  static std::string University(int number) {
    return "http://www.University" + std::to_string(number) + ".example.org";
  }

  int Draw(int least, int most) {  // the same on every machine, unlike std's distributions
    return least + static_cast<int>(random_() % static_cast<unsigned>(most - least + 1));
  }

  template <typename List>
  const typename List::value_type& AnyOf(const List& list) {
    return list[static_cast<std::size_t>(Draw(0, static_cast<int>(list.size()) - 1))];
  }

  void Begin(const std::string& subject, const std::string& predicate) {
    text_.append("<").append(subject).append("> <").append(predicate).append("> ");
  }
  void Is(const std::string& subject, const std::string& type) {
    Begin(subject, kType);
    text_.append("<").append(kWords).append(type).append("> .\n");
  }
  void Links(const std::string& subject, const std::string& property, const std::string& object) {
    Begin(subject, kWords + property);
    text_.append("<").append(object).append("> .\n");
  }
  void Says(const std::string& subject, const std::string& property, const std::string& value) {
    Begin(subject, kWords + property);
    text_.append("\"").append(value).append("\" .\n");
  }

  std::string Person(const std::string& kind, int index) {
    const std::string local = kind + std::to_string(index);
    std::string person = department_ + "/" + local;
    Is(person, kind);
    Says(person, "name", local);
    Says(person, "emailAddress", local + "@" + department_.substr(7));
    Says(person, "telephone", "xxx-xxx-xxxx");
    return person;
  }

  void Degree(const std::string& person, const std::string& property) {
    Links(person, property, University(Draw(0, kUniversities - 1)));
  }

  std::string Course(const std::string& kind) {
    auto& courses = kind == "Course" ? courses_ : graduate_courses_;
    std::string course = department_ + "/" + kind + std::to_string(courses.size());
    Is(course, kind);
    Says(course, "name", kind + std::to_string(courses.size()));
    courses.push_back(course);
    return course;
  }

  void Teachers(const std::string& kind, int count, int least_papers, int most_papers) {
    for (int i = 0; i < count; ++i) {
      const std::string person = Person(kind, i);
      Links(person, "worksFor", department_);
      if (kind == "FullProfessor" && i == 0) Links(person, "headOf", department_);
      for (const char* degree :
           {"undergraduateDegreeFrom", "mastersDegreeFrom", "doctoralDegreeFrom"}) {
        Degree(person, degree);
      }
      if (kind != "Lecturer") {
        Says(person, "researchInterest", "Research" + std::to_string(Draw(0, 29)));
        professors_.push_back(person);
      }
      for (int k = Draw(1, 2); k > 0; --k) Links(person, "teacherOf", Course("Course"));
      for (int k = Draw(1, 2); k > 0; --k) Links(person, "teacherOf", Course("GraduateCourse"));
      for (int k = Draw(least_papers, most_papers), n = 0; n < k; ++n) {
        papers_.push_back(person + "/Publication" + std::to_string(n));
        Is(papers_.back(), "Publication");
        Says(papers_.back(), "name", "Publication" + std::to_string(n));
        Links(papers_.back(), "publicationAuthor", person);
      }
      ++teachers_;
    }
  }

  void Courses(const std::string& student, const std::vector<std::string>& courses, int count) {
    for (int k = 0; k < count; ++k) Links(student, "takesCourse", AnyOf(courses));
  }

  void Students() {
    const int undergraduates = teachers_ * Draw(8, 14);
    for (int i = 0; i < undergraduates; ++i) {
      const std::string student = Person("UndergraduateStudent", i);
      Links(student, "memberOf", department_);
      Courses(student, courses_, Draw(2, 4));
      if (Draw(1, 5) == 1) Links(student, "advisor", AnyOf(professors_));
    }
    const int graduates = teachers_ * Draw(3, 4);
    for (int i = 0; i < graduates; ++i) {
      const std::string student = Person("GraduateStudent", i);
      Links(student, "memberOf", department_);
      Degree(student, "undergraduateDegreeFrom");
      Courses(student, graduate_courses_, Draw(1, 3));
      Links(student, "advisor", AnyOf(professors_));
      if (Draw(1, 4) == 1) {
        Links(student, "teachingAssistantOf", AnyOf(courses_));
      } else if (Draw(1, 3) == 1) {
        Is(student, "ResearchAssistant");
      }
      for (int k = Draw(0, 5); k > 0; --k) Links(AnyOf(papers_), "publicationAuthor", student);
    }
  }

  void Department(int index) {
    department_ = "http://www.Department" + std::to_string(index) + "." + home_.substr(11);
    courses_.clear();
    graduate_courses_.clear();
    professors_.clear();
    papers_.clear();
    teachers_ = 0;
    Is(department_, "Department");
    Says(department_, "name", "Department" + std::to_string(index));
    Links(department_, "subOrganizationOf", home_);
    Teachers("FullProfessor", Draw(7, 10), 15, 20);
    Teachers("AssociateProfessor", Draw(10, 14), 10, 18);
    Teachers("AssistantProfessor", Draw(8, 11), 5, 10);
    Teachers("Lecturer", Draw(5, 7), 0, 5);
    Students();
    for (int i = 0, groups = Draw(10, 20); i < groups; ++i) {
      const std::string group = department_ + "/ResearchGroup" + std::to_string(i);
      Is(group, "ResearchGroup");
      Links(group, "subOrganizationOf", department_);
    }
  }

  int number_;
  std::mt19937 random_;
  std::string home_, department_, text_;
  std::vector<std::string> courses_, graduate_courses_, professors_, papers_;
  int teachers_ = 0;
};

}  // namespace

std::string UniversityOntology() { return kOntology; }

std::string University(int number) { return Writer(number).Write(); }

}  // namespace lares::bench
